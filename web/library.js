"use strict";

// An address in the library's memory with the type of its content: a structure of kstrip.h, "double" or "uint32_t".
class Pointer {
    constructor(type, address) {
        this.type = type;
        this.address = address;
        Object.freeze(this);
    }
}

// An error status of a function of the library, in words.
class StatusError extends Error {}

// Runs `action`; an error status in it names the part of the computation that failed.
function about(part, action) {
    try {
        return action();
    } catch (error) {
        if (error instanceof StatusError) error.message = `${part}: ${error.message}`;
        throw error;
    }
}

// The C library in WebAssembly. Structures and calls follow the layouts and the prototypes of kstrip.h.
class Library {
    // instance: the instantiated module. header: { structures, constants, functions }, made from kstrip.h by assemble.py.
    constructor(instance, header) {
        this.exports = instance.exports;
        this.structures = header.structures;
        this.constants = header.constants;
        this.functions = header.functions;
        for (const [name, { parameters }] of Object.entries(header.functions)) {
            if (this.exports[name]?.length !== parameters.length) throw new Error(`${name}() of the library is not that of kstrip.h`);
        }
        this.memory = instance.exports.memory;
        this.kept = instance.exports.__heap_base.value;
        this.next = this.kept;
    }

    // ------------------------------------------------------------ memory

    size(type) {
        return this.structures[type]?.size ?? (type === "double" ? 8 : 4);
    }

    // An array of `count` zeroed elements, aligned for doubles. It lasts until the next release().
    allocate(type, count = 1) {
        const address = (this.next + 15) & ~15, size = count * this.size(type);
        this.next = address + size;
        const missing = this.next - this.memory.buffer.byteLength;
        if (missing > 0) this.memory.grow(Math.ceil(missing / 65536));
        new Uint8Array(this.memory.buffer, address, size).fill(0);
        return new Pointer(type, address);
    }

    // The memory that is allocated now stays for good.
    keep() {
        this.kept = this.next;
    }

    // Frees all memory that was allocated after keep().
    release() {
        this.next = this.kept;
    }

    // A structure with these members; the other members are zero, the library's default.
    make(type, values = {}) {
        const pointer = this.allocate(type);
        this.write(pointer, values);
        return pointer;
    }

    // An array of doubles.
    doubles(values) {
        const pointer = this.allocate("double", values.length);
        new Float64Array(this.memory.buffer, pointer.address, values.length).set(values);
        return pointer;
    }

    // Element `index` of an array.
    element(pointer, index) {
        return new Pointer(pointer.type, pointer.address + index * this.size(pointer.type));
    }

    // Member `name` of a structure.
    member(pointer, name) {
        const member = this.structures[pointer.type].members[name];
        if (!member) throw new TypeError(`${pointer.type} has no member ${name}`);
        return new Pointer(member.type, pointer.address + member.offset);
    }

    // Writes members of a structure.
    write(pointer, values) {
        const view = new DataView(this.memory.buffer);
        for (const [name, value] of Object.entries(values)) {
            const { address } = this.member(pointer, name), member = this.structures[pointer.type].members[name];
            const step = member.pointer ? 4 : this.size(member.type);
            const all = member.count === undefined ? [value] : value;
            all.forEach((one, i) => {
                const number = Library.checked(member, one, `${pointer.type}.${name}`), at = address + i * step;
                if (member.pointer) view.setUint32(at, number, true);
                else if (member.type === "double") view.setFloat64(at, number, true);
                else view.setInt32(at, number, true);
            });
        }
    }

    // A number, or a structure as an object whose arrays are flat.
    read(pointer) {
        const { type, address } = pointer, view = new DataView(this.memory.buffer);
        if (type === "double") return view.getFloat64(address, true);
        if (!this.structures[type]) return type === "uint32_t" ? view.getUint32(address, true) : view.getInt32(address, true);
        return Object.fromEntries(Object.entries(this.structures[type].members).filter(([, member]) => !member.pointer)
            .map(([name, member]) => [name, member.count === undefined
                ? this.read(this.member(pointer, name)) : this.readAll(this.member(pointer, name), member.count)]));
    }

    // The first `count` elements of an array.
    readAll(pointer, count) {
        return Array.from({ length: count }, (_, i) => this.read(this.element(pointer, i)));
    }

    text(address) {
        const bytes = new Uint8Array(this.memory.buffer, address);
        return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
    }

    // ------------------------------------------------------------ calls

    // The number that WebAssembly takes for `value`, if `value` is of the kind that the header declares: a Pointer of this type or null,
    // an integer, or a double. `kind` is { type, pointer }; `where` names the parameter or member in the error.
    static checked(kind, value, where) {
        if (kind.pointer) {
            if (value === null) return 0;
            if (value instanceof Pointer && value.type === kind.type) return value.address;
            throw new TypeError(`${where} is a pointer to ${kind.type}, not ${value instanceof Pointer ? `to ${value.type}` : value}`);
        }
        const fits = kind.type === "double" ? typeof value === "number" : kind.type === "uint32_t" ? value >>> 0 === value : (value | 0) === value;
        if (!fits) throw new TypeError(`${where} is of type ${kind.type}, not ${value instanceof Pointer ? "a pointer" : value}`);
        return value;
    }

    // Calls kstrip_NAME with the arguments of its prototype. Returns OK or a warning, or a text; an error status is thrown as a StatusError.
    call(name, ...values) {
        const { parameters, text } = this.functions[`kstrip_${name}`];
        if (values.length !== parameters.length) {
            throw new TypeError(`kstrip_${name}() takes ${parameters.length} arguments, not ${values.length}`);
        }
        const numbers = values.map((value, i) => Library.checked(parameters[i], value, `${parameters[i].name} of kstrip_${name}()`));
        const result = this.exports[`kstrip_${name}`](...numbers);
        if (text) return this.text(result);
        if (result < 0) throw new StatusError(this.message(result));
        return result;
    }

    // The meaning of a status; "" for OK.
    message(status) {
        return status === 0 ? "" : this.call("status_string", status);
    }
}
