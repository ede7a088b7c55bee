// Run before the scripts of the browser demo: notes each call of the library that fails or that has a wrong number of arguments.
window.called = new Set();
window.failures = [];
const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (...given) => {
    const { instance } = await instantiate.apply(WebAssembly, given), exports = { ...instance.exports };
    for (const [name, function_] of Object.entries(exports)) {
        if (!name.startsWith("kstrip_")) continue;
        exports[name] = (...numbers) => {
            const result = function_(...numbers);
            called.add(name);
            if (result < 0 || numbers.length !== function_.length) failures.push(`${name}, ${numbers.length} arguments: ${result}`);
            return result;
        };
        Object.defineProperty(exports[name], "length", { value: function_.length });
    }
    return { instance: { exports } };
};
