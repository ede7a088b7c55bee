"use strict";

// The C library in WebAssembly: structures are written to and read from its memory by the layouts of kstrip.h.
class Library {
    // instance: the instantiated module. layout: { structures, constants }, made from kstrip.h by assemble.py.
    constructor(instance, layout) {
        this.functions = instance.exports;
        this.structures = layout.structures;
        this.constants = layout.constants;
        this.memory = instance.exports.memory;
        this.kept = instance.exports.__heap_base.value;
        this.next = this.kept;
    }

    // Memory until the next release(), zeroed, aligned for doubles.
    allocate(size) {
        const pointer = (this.next + 15) & ~15;
        this.next = pointer + size;
        const missing = this.next - this.memory.buffer.byteLength;
        if (missing > 0) this.memory.grow(Math.ceil(missing / 65536));
        new Uint8Array(this.memory.buffer, pointer, size).fill(0);
        return pointer;
    }

    // What was allocated so far stays.
    keep() {
        this.kept = this.next;
    }

    // Frees everything that keep() did not keep.
    release() {
        this.next = this.kept;
    }

    // A structure from the members that are given; the others are zero, the library's default.
    make(name, values = {}) {
        const structure = this.structures[name];
        const pointer = this.allocate(structure.size);
        this.write(name, pointer, values);
        return pointer;
    }

    write(name, pointer, values) {
        const view = new DataView(this.memory.buffer);
        for (const [key, value] of Object.entries(values)) {
            const member = this.structures[name].members[key];
            if (!member) throw new Error(`${name} has no member ${key}`);
            const all = member.count === undefined ? [value] : value;
            all.forEach((one, i) => {
                const at = pointer + member.offset + i * Library.size(member.type);
                if (member.type === "double") view.setFloat64(at, one, true);
                else if (member.type === "int32_t") view.setInt32(at, one, true);
                else view.setUint32(at, one, true);
            });
        }
    }

    static size(type) {
        return type === "double" ? 8 : 4;
    }

    // A structure as an object; arrays flat. `most` bounds the elements of arrays of structures.
    read(name, pointer, most = Infinity) {
        const view = new DataView(this.memory.buffer);
        const read = (type, at) => {
            if (this.structures[type]) return this.read(type, at, most);
            if (type === "double") return view.getFloat64(at, true);
            return type === "int32_t" ? view.getInt32(at, true) : view.getUint32(at, true);
        };
        const found = {};
        for (const [key, member] of Object.entries(this.structures[name].members)) {
            const at = pointer + member.offset;
            if (member.count === undefined) {
                found[key] = read(member.type, at);
                continue;
            }
            const step = this.structures[member.type]?.size ?? Library.size(member.type);
            const count = this.structures[member.type] ? Math.min(member.count, most) : member.count;
            found[key] = Array.from({ length: count }, (_, i) => read(member.type, at + i * step));
        }
        return found;
    }

    // The first `count` structures of an array.
    readAll(name, pointer, count) {
        const size = this.structures[name].size;
        return Array.from({ length: count }, (_, i) => this.read(name, pointer + i * size));
    }

    doubles(values) {
        const pointer = this.allocate(8 * values.length);
        new Float64Array(this.memory.buffer, pointer, values.length).set(values);
        return pointer;
    }

    readDoubles(pointer, count) {
        return Array.from(new Float64Array(this.memory.buffer, pointer, count));
    }

    text(pointer) {
        const bytes = new Uint8Array(this.memory.buffer, pointer);
        return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
    }

    // kstrip_NAME: a status, or what the function returns.
    call(name, ...values) {
        return this.functions[`kstrip_${name}`](...values);
    }

    // What a status means, in English; "" where all is well.
    message(status) {
        return status === 0 ? "" : this.text(this.call("status_string", status));
    }

    version() {
        return this.text(this.call("version_string"));
    }
}
