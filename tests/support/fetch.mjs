// Gets the packages of a folder's package-lock.json into its node_modules, each checked against its sum there.
// Does what `npm ci --ignore-scripts` does, for whoever has node without npm. node fetch.mjs FOLDER
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, renameSync, rmSync } from 'node:fs';
import { resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const here = pathToFileURL(`${resolve(process.argv[2])}/`);

function isThere(path, wanted) {
    const file = new URL(`${path}/package.json`, here);
    return existsSync(file) && JSON.parse(readFileSync(file)).version === wanted.version;
}

async function download({ resolved, integrity }) {
    const answer = await fetch(resolved, { signal: AbortSignal.timeout(60000) });
    if (!answer.ok) throw new Error(`${resolved}: ${answer.status}`);
    const bytes = Buffer.from(await answer.arrayBuffer());
    const [algorithm, sum] = integrity.split(/-(.*)/s);
    if (createHash(algorithm).update(bytes).digest('base64') !== sum)
        throw new Error(`${resolved}: wrong checksum`);
    return bytes;
}

// Unpacked beside its place first, so that no half of a package is ever found there.
function unpack(bytes, path) {
    const place = new URL(path, here), part = new URL(`${path}.part`, here);
    for (const folder of [place, part]) rmSync(folder, { recursive: true, force: true });
    mkdirSync(part, { recursive: true });
    const leftOut = ['--exclude=*.map', '--exclude=*.d.ts'];
    const options = ['-xz', '--strip-components=1', ...leftOut, '-C', fileURLToPath(part)];
    execFileSync('tar', options, { input: bytes });
    renameSync(part, place);
}

const { packages } = JSON.parse(readFileSync(new URL('package-lock.json', here)));
try {
    for (const [path, wanted] of Object.entries(packages))
        if (path && !isThere(path, wanted)) unpack(await download(wanted), path);
} catch (error) {
    console.error(`fetch.mjs: ${error.cause?.code ?? error.message}`);
    process.exitCode = 1;
}
