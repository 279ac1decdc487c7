// Flamenco 3 job type: draws the frames of a .blend in chunks and merges them into keyframes
// (docs/farm.md). It belongs into the folder `scripts` beside the Manager.

const JOB_TYPE = {
    label: "Illustrate",
    description: "Line illustrations of frames: as files, and as keyframes of one .blend",
    settings: [
        { key: "frames", type: "string", required: true,
          eval: "f'{C.scene.frame_start}-{C.scene.frame_end}'",
          evalInfo: { showLinkButton: true, description: "Frames of the scene" },
          description: "Such as 47, 1-30 or 3,5-10,47-327" },
        { key: "chunk_size", type: "int32", default: 10, propargs: { min: 1 },
          visible: "submission", description: "Frames of one task" },
        { key: "output", type: "string", subtype: "dir_path", required: true,
          description: "Where drawings go: a folder that all workers see" },
        { key: "merged", type: "string", subtype: "file_path", default: "",
          description: "The .blend that gets the keyframes: a copy of the one that is drawn where it is not there. Nothing is merged without it" },
        { key: "formats", type: "string", default: "svg,json",
          description: "Of svg, png, json, blend; json is needed to merge" },
        { key: "expose_as", type: "int32", eval: "C.scene.frame_start", visible: "submission",
          description: "Frame that gives all the exposure" },
        { key: "warm_up", type: "int32", default: 2, propargs: { min: 0 }, visible: "submission",
          description: "Frames drawn before each chunk, so that strokes go on from it" },
        { key: "script", type: "string", subtype: "file_path", default: "", visible: "submission",
          description: "headless.py, for Blenders without the command of the extension" },
        { key: "blendfile", type: "string", required: true, visible: "web",
          description: "The file that is drawn" },
    ],
};

function compileJob(job) {
    const settings = job.settings;
    if (settings.merged && !settings.formats.split(",").includes("json")) {
        throw "Merging needs json among the formats";
    }
    const drawn = frameChunker(settings.frames, settings.chunk_size).map(
        (chunk) => drawTask(settings, chunk));
    for (const task of drawn) {
        job.addTask(task);
    }
    if (settings.merged) {
        const merge = mergeTask(settings);
        for (const task of drawn) {
            merge.addDependency(task);
        }
        job.addTask(merge);
    }
}

function drawTask(settings, chunk) {
    const task = author.Task(`draw-${chunk}`, "blender");
    task.addCommand(illustrate(settings, [
        `--out=${settings.output}`,
        `--name=${path.stem(settings.blendfile).replace(".flamenco", "")}_####`,
        `--frames=${chunk}`,
        `--format=${settings.formats}`,
        `--expose-as=${settings.expose_as}`,
        `--warm-up=${settings.warm_up}`,
        "--skip-existing",
        "--progress=none",
    ]));
    return task;
}

function mergeTask(settings) {
    const task = author.Task("merge", "blender");
    task.addCommand(illustrate(settings, [
        "merge", settings.output,
        `--into=${settings.merged}`,
        `--from=${settings.blendfile}`,
        `--frames=${settings.frames.replaceAll("..", "-").replaceAll(" ", "")}`,
    ]));
    return task;
}

// A command that Blender itself passes on takes all that follows.
function illustrate(settings, words) {
    const start = settings.script
        ? ["--python-exit-code", "3", "--python", settings.script, "--"]
        : ["--command", "illustrate"];
    return author.Command("blender-render", {
        exe: "{blender}",
        exeArgs: "{blenderArgs}",
        argsBefore: [],
        blendfile: settings.blendfile,
        args: start.concat(words),
    });
}
