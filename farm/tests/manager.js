// manager.js JOB_TYPE.js JOB.json: compiles a job as the Manager of Flamenco 3 does, and prints the
// tasks as JSON. What the Manager has not, or what a script may not ask of it, is an error. The
// Manager's names: its Go files js_globals.go, js_path.go, author.go; those of commands: the
// Worker's cmd_executor.go and command_blender.go.

"use strict";
const fs = require("fs");
const vm = require("vm");

const SETTING_TYPES = { string: "string", int32: "number", float: "number", bool: "boolean" };
const SETTING_KEYS = ["key", "type", "subtype", "choices", "propargs", "description", "default",
                      "eval", "evalInfo", "visible", "required", "editable", "label"];
const VISIBLE = ["visible", "hidden", "submission", "web"];
const SUBTYPES = ["file_path", "dir_path", "file_name", "hashed_file_path"];
const COMMANDS = { "blender-render": ["exe", "exeArgs", "argsBefore", "blendfile", "args"] };
const TASK_TYPES = ["blender", "ffmpeg", "file-management", "misc"];

function check(holds, words) {
    if (!holds) {
        throw new Error(words);
    }
}

// An object that has these members and no others.
function strict(name, members) {
    return new Proxy(members, {
        get(target, key) {
            check(key in target, `${name} has no ${String(key)}`);
            return target[key];
        },
        set(_, key) {
            throw new Error(`${name}.${String(key)} cannot be set`);
        },
    });
}

function frameRange(text) {
    const frames = new Set();
    for (const part of text.replaceAll("..", "-").split(",")) {
        const ends = part.split("-").map((word) => word.trim());
        check(ends.length <= 2 && ends.every((word) => /^\d+$/.test(word)), `invalid range ${part}`);
        for (let frame = Number(ends[0]); frame <= Number(ends.at(-1)); ++frame) {
            frames.add(frame);
        }
    }
    return [...frames].sort((a, b) => a - b);
}

// Consecutive frames as A-B; two stay two.
function merged(frames) {
    const runs = [];
    for (const frame of frames) {
        const run = runs.at(-1);
        if (run && frame === run.at(-1) + 1) {
            run.push(frame);
        } else {
            runs.push([frame]);
        }
    }
    return runs.map((run) => (run.length < 3 ? run.join(",") : `${run[0]}-${run.at(-1)}`)).join(",");
}

function frameChunker(text, size) {
    check(Number.isInteger(size) && size > 0, `invalid chunk size ${size}`);
    const frames = frameRange(text);
    const chunks = [];
    for (let i = 0; i < frames.length; i += size) {
        chunks.push(merged(frames.slice(i, i + size)));
    }
    return chunks;
}

function newTask(name, type) {
    check(name.trim() && TASK_TYPES.includes(type), `no task ${name} of type ${type}`);
    const task = { name, type, commands: [], dependencies: [] };
    return strict("a task", {
        ...task,
        task,
        addCommand: (command) => task.commands.push(command),
        addDependency: (other) => task.dependencies.push(other.task.name),
    });
}

function newCommand(name, parameters) {
    check(name in COMMANDS, `no command ${name}`);
    for (const key of Object.keys(parameters)) {
        check(COMMANDS[name].includes(key), `${name} takes no ${key}`);
    }
    const texts = [parameters.exe, parameters.exeArgs, parameters.blendfile,
                   ...parameters.argsBefore, ...parameters.args];
    check(texts.every((text) => typeof text === "string"), `${name}: not all are texts`);
    return { name, parameters };
}

const path = {
    basename: (file) => file.split(/[/\\]/).at(-1),
    dirname: (file) => file.split(/[/\\]/).slice(0, -1).join("/") || ".",
    join: (...parts) => parts.join("/"),
    stem: (file) => path.basename(file).replace(/\.[^.]*$/, ""),
};

// The settings of a job: what was chosen, else what stands in the job type.
function settingsOf(jobType, chosen) {
    const settings = {};
    for (const setting of jobType.settings) {
        const { key, type, subtype, visible } = setting;
        for (const word of Object.keys(setting)) {
            check(SETTING_KEYS.includes(word), `setting ${key} has ${word}`);
        }
        check(type in SETTING_TYPES, `setting ${key} is of type ${type}`);
        check(!subtype || SUBTYPES.includes(subtype), `setting ${key} is of subtype ${subtype}`);
        check(!visible || VISIBLE.includes(visible), `setting ${key} is visible ${visible}`);
        check(setting.description, `setting ${key} has no description`);
        const value = key in chosen ? chosen[key] : setting.default;
        check(typeof value === SETTING_TYPES[type], `setting ${key} is ${value}`);
        settings[key] = value;
    }
    for (const key of Object.keys(chosen)) {
        check(key in settings, `no setting ${key}`);
    }
    return strict("settings", settings);
}

function compile(script, chosen) {
    const tasks = [];
    const globals = {
        author: strict("author", { Task: newTask, Command: newCommand }),
        frameChunker,
        path: strict("path", path),
    };
    const context = vm.createContext(globals);
    vm.runInContext("delete globalThis.console", context); // Node's, not the Manager's
    vm.runInContext(`"use strict";${fs.readFileSync(script, "utf-8")}
        this.compileJob = compileJob; this.JOB_TYPE = JOB_TYPE;`, context, { filename: script });
    const addTask = ({ task }) => tasks.push(structuredClone(task)); // as it is now
    context.compileJob(strict("job", { settings: settingsOf(context.JOB_TYPE, chosen), addTask }));
    return tasks;
}

const [script, job] = process.argv.slice(2);
try {
    console.log(JSON.stringify(compile(script, JSON.parse(fs.readFileSync(job, "utf-8")))));
} catch (error) {
    console.error(String(error.message ?? error));
    process.exitCode = 1;
}
