// Opens the viewer in Chromium and checks that it works for whoever comes to it. node browser.mjs PROGRAM
// One line for each check, stops at the first that fails. Exits with 77, which skips the test, where the
// browser or its package is missing; with LAMBENT_REQUIRE_BROWSER in the environment it fails instead.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

function missing(what) {
    const isRequired = Boolean(process.env.LAMBENT_REQUIRE_BROWSER);
    console.log(`${isRequired ? 'missing' : 'skipped'}: ${what}`);
    process.exit(isRequired ? 1 : 77);
}

// By how much longer the program may take; sanitizers slow it down.
const patience = Number(process.env.LAMBENT_PATIENCE ?? 1);

async function startBrowser() {
    let found;
    try {
        found = createRequire(new URL('../report/package.json', import.meta.url)).resolve('playwright-core');
    } catch {
        missing('no playwright-core; `node tests/support/fetch.mjs tests/report` gets it');
    }
    const module = await import(pathToFileURL(found));
    const { chromium } = module.chromium ? module : module.default;
    const places = [process.env.CHROMIUM ?? '', '/usr/bin/chromium', '/usr/bin/chromium-browser'];
    const executablePath = places.find(existsSync);
    if (!executablePath) missing('no Chromium (Debian package chromium)');
    // Chromium's sandbox does not start for root.
    return chromium.launch({ executablePath, args: process.getuid() === 0 ? ['--no-sandbox'] : [] });
}

// The address that a server prints when it is ready.
function startServer(program, words) {
    const server = spawn(program, ['serve', ...words], { stdio: ['ignore', 'pipe', 'inherit'] });
    return new Promise((done, fail) => {
        server.stdout.once('data', line => done({ server, address: String(line).trim() }));
        server.once('exit', code => fail(new Error(`the server ended with ${code}`)));
    });
}

const program = resolve(process.argv[2]);
const folder = mkdtempSync(join(tmpdir(), 'lambent-serve-'));
const browser = await startBrowser();
// Without bounces of light pictures come to rest at once.
const { server, address } = await startServer(program, ['grid', '--bounces', '0', '--port', '0', '--quiet']);

// Calls use(page, context) with a fresh page that shows its first picture at rest; nothing may be complained of.
async function open({ width = 900, height = 400, at = address, ...options }, use) {
    const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true, ...options });
    const page = await context.newPage(), troubles = [];
    page.setDefaultTimeout(30000 * patience);
    page.on('console', message => {
        if (['error', 'warning'].includes(message.type())) troubles.push(`console: ${message.text()}`);
    });
    page.on('pageerror', error => troubles.push(`script: ${error.message}`));
    page.on('request', request => {
        if (!request.url().startsWith(at) && !/^(data|blob):/.test(request.url()))
            troubles.push(`asked for ${request.url()}`);
    });
    await page.goto(at);
    await rest(page, 1);
    await use(page, context);
    assert.deepEqual(troubles, []);
    await context.close();
}

// Waits for a picture at rest that shows this many inputs.
const rest = (page, inputs) => page.waitForFunction(wanted => {
    const { kind, input } = document.getElementById('picture').dataset;
    return kind === 'rest' && Number(input) >= wanted;
}, inputs, { timeout: 30000 * patience });

// What the page has said so far is shown: nothing is on its way any more.
async function settled(page) {
    await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
    await rest(page, await page.evaluate('inputs'));
}

const pixels = page => page.evaluate(() => {
    const { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, width, height);
    let sum = 0, hash = 0;
    for (let i = 0; i < data.length; i += 4) {
        sum += data[i] + data[i + 1] + data[i + 2];
        hash = (hash * 31 + data[i] * 65536 + data[i + 1] * 256 + data[i + 2]) % 4294967291;
    }
    return { width, height, mean: sum / (width * height * 3), hash };
});

const camera = async page => (await page.inputValue('#command')).match(/--camera (\S+)/)[1].split(',').map(Number);

async function drag(page, from, to, options = {}) {
    await page.mouse.move(...from);
    await page.mouse.down(options);
    for (let i = 1; i <= 8; ++i)
        await page.mouse.move(...from.map((start, axis) => start + (to[axis] - start) * i / 8));
    await page.mouse.up(options);
    await settled(page);
}

async function slide(page, id, keys, times) {
    await page.focus(id);
    for (let i = 0; i < times; ++i) await page.keyboard.press(keys);
    await settled(page);
}

// Mean differences of code values between two JPEGs, left of a column and right of it.
const difference = (page, one, two, column) => page.evaluate(async ([a, b, middle]) => {
    const read = async base64 => {
        const bytes = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
        const picture = await createImageBitmap(new Blob([bytes], { type: 'image/jpeg' }));
        const paper = new OffscreenCanvas(picture.width, picture.height).getContext('2d', { willReadFrequently: true });
        paper.drawImage(picture, 0, 0);
        return paper.getImageData(0, 0, picture.width, picture.height);
    };
    const [first, second] = [await read(a), await read(b)];
    if (first.width !== second.width || first.height !== second.height) return null;
    const sums = [0, 0], counts = [0, 0];
    first.data.forEach((value, i) => {
        const side = Math.floor(i / 4) % first.width < middle ? 0 : 1;
        sums[side] += Math.abs(value - second.data[i]);
        ++counts[side];
    });
    return sums.map((sum, side) => sum / counts[side]);
}, [one.toString('base64'), two.toString('base64'), column]);

// A triangle that slides a metre to the right in two seconds.
function movingModel() {
    const numbers = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, /* times */ 0, 2, /* places */ 0, 0, 0, 1, 0, 0]);
    const view = (byteOffset, byteLength) => ({ buffer: 0, byteOffset, byteLength });
    const accessor = (bufferView, count, type, more = {}) => ({ bufferView, componentType: 5126, count, type, ...more });
    return {
        asset: { version: '2.0' },
        buffers: [{ byteLength: numbers.byteLength,
                    uri: `data:application/octet-stream;base64,${Buffer.from(numbers.buffer).toString('base64')}` }],
        bufferViews: [view(0, 36), view(36, 8), view(44, 24)],
        accessors: [accessor(0, 3, 'VEC3', { min: [0, 0, 0], max: [1, 1, 0] }),
                    accessor(1, 2, 'SCALAR', { min: [0], max: [2] }), accessor(2, 2, 'VEC3')],
        meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
        nodes: [{ mesh: 0 }],
        scenes: [{ nodes: [0] }],
        animations: [{ name: 'slide', samplers: [{ input: 1, output: 2 }],
                       channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }] }],
    };
}

// The picture in docs/VIEWER.md. LAMBENT_UPDATE_PICTURES=1 makes it anew.
async function expectCommittedPicture(page) {
    const file = fileURLToPath(new URL('../../docs/viewer/browser.jpg', import.meta.url));
    const shot = await page.screenshot({ type: 'jpeg', quality: 85 });
    if (process.env.LAMBENT_UPDATE_PICTURES) writeFileSync(file, shot);
    const panel = await page.locator('#panel').boundingBox();
    const apart = await difference(page, shot, readFileSync(file), panel.x);
    // Letters differ from machine to machine; light does not.
    if (!apart || apart[0] > 1 || apart[1] > 6) {
        const seen = join(tmpdir(), 'lambent-browser.jpg');
        writeFileSync(seen, shot);
        assert.fail(`${seen} is not docs/viewer/browser.jpg: ${apart}`);
    }
}

const checks = {
    'the page loads and shows the scene': () => open({}, async page => {
        assert.equal(await page.title(), 'grid - lambent');
        const { width, height, mean } = await pixels(page);
        const box = await page.locator('#picture').boundingBox();
        assert.deepEqual([width, height], [box.width, box.height]);
        assert.ok(mean > 20 && mean < 235, `mean ${mean}`);
    }),
    'it looks like the picture in the documentation, and gets better by itself': async () => {
        const { server: lit, address: at } = await startServer(program, ['grid', '--port', '0', '--quiet']);
        try {
            await open({ at, width: 1280, height: 720 }, async page => {
                await drag(page, [300, 300], [220, 340]);
                await page.waitForFunction(() => /error \d.* % \(\d.* to \d.*\)/.test(
                    document.getElementById('status').textContent), null, { timeout: 60000 * patience });
                await expectCommittedPicture(page);
                await page.waitForFunction(() => / --passes \d/.test(document.getElementById('command').value), null,
                                           { timeout: 60000 * patience });
            });
        } finally {
            lit.kill('SIGKILL');
        }
    },
    'dragging turns, shifts and turns the light': () => open({}, async page => {
        const before = await pixels(page), [azimuth, elevation] = await camera(page);
        await drag(page, [200, 200], [280, 160]);
        const [turned, raised] = await camera(page);
        assert.ok(turned < azimuth - 10 && raised < elevation - 5, `${turned} ${raised}`);
        assert.notEqual((await pixels(page)).hash, before.hash);
        await drag(page, [200, 200], [260, 200], { button: 'right' });
        assert.match(await page.inputValue('#command'), /--target \S+/);
        await page.keyboard.down('Shift');
        await drag(page, [200, 200], [260, 200]);
        await page.keyboard.up('Shift');
        assert.match(await page.inputValue('#command'), /--env-rotation \d/);
        await page.click('#reset');
        await settled(page);
        assert.equal((await pixels(page)).hash, before.hash);
    }),
    'the wheel goes nearer, a double click looks at a point': () => open({}, async page => {
        await page.mouse.move(190, 200);
        await page.mouse.wheel(0, -300);
        await settled(page);
        const near = (await camera(page))[2];
        await page.mouse.wheel(0, 600);
        await settled(page);
        assert.ok((await camera(page))[2] > near * 1.5);
        const target = async () => (await page.inputValue('#command')).match(/--target (\S+)/)[1];
        const before = await target();
        const box = await page.locator('#picture').boundingBox();
        await page.mouse.dblclick(box.x + box.width / 2, box.y + box.height / 2); // on the middle sphere
        await page.waitForFunction(old => !document.getElementById('command').value.includes(`--target ${old} `), before);
        assert.notEqual(await target(), before);
    }),
    'keys turn, list themselves and hide the controls': () => open({}, async page => {
        await page.focus('#picture');
        const [azimuth] = await camera(page);
        await page.keyboard.press('ArrowRight');
        await settled(page);
        assert.ok((await camera(page))[0] > azimuth + 4);
        await page.keyboard.press('?');
        assert.ok(await page.locator('#help').isVisible());
        await page.keyboard.press('Escape');
        await page.keyboard.press('p');
        assert.ok(!await page.locator('#panel').isVisible());
    }),
    'controls do what they say': () => open({}, async page => {
        const before = await pixels(page);
        await slide(page, '#set-exposure', 'ArrowRight', 60);
        assert.ok((await pixels(page)).mean > before.mean * 1.1);
        await page.selectOption('#set-layer', 'normal');
        await settled(page);
        const normal = await pixels(page);
        await page.selectOption('#set-layer', 'picture');
        await page.selectOption('#set-model', 'phong');
        await page.click('#add-directional');
        await settled(page);
        assert.notEqual((await pixels(page)).hash, normal.hash);
        assert.ok(await page.locator('#set-alpha').isVisible());
        assert.match(await page.inputValue('#command'), /--model phong .*--light directional:45,45,2,2,2/);
        await page.click('text=Remove sun 1');
        await settled(page);
        assert.doesNotMatch(await page.inputValue('#command'), /--light/);
        await page.selectOption('#environment', 'studio');
        await page.waitForFunction(() => document.getElementById('command').value.includes('--env studio'));
    }),
    'the reference follows the picture with its error': () => open({ width: 620, height: 200 }, async page => {
        const drawn = await pixels(page);
        await page.selectOption('#set-layer', 'reference');
        const traced = () => page.waitForFunction(() => document.getElementById('picture').dataset.kind === 'traced');
        await traced();
        assert.match(await page.textContent('#status'), /traced: \d+ samples.*error [\d.]+ %/);
        const { mean } = await pixels(page);
        assert.ok(Math.abs(mean / drawn.mean - 1) < 0.15, `${mean} ${drawn.mean}`);
        await page.selectOption('#set-layer', 'error');
        await page.waitForFunction(() => document.getElementById('status').textContent.includes('FLIP'));
        assert.ok((await pixels(page)).mean < drawn.mean / 2);
        await page.selectOption('#set-layer', 'picture');
        await settled(page);
        assert.equal((await pixels(page)).hash, drawn.hash);
    }),
    'a file dropped on the page is refused with a reason': () => open({}, async page => {
        await page.evaluate(() => {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File(['x'], 'model.glb'));
            document.dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
        });
        assert.match(await page.textContent('#trouble'), /folders of the server/);
    }),
    'what need not be set is taken back': () => open({}, async page => {
        const number = page.locator('[aria-label="Roughness"]');
        const before = await pixels(page);
        await slide(page, '#set-roughness', 'ArrowRight', 10);
        assert.match(await page.inputValue('#command'), / --roughness 0\.5/);
        assert.notEqual((await pixels(page)).hash, before.hash);
        await page.click('[aria-label="Roughness: default"]');
        await settled(page);
        assert.doesNotMatch(await page.inputValue('#command'), /--roughness/);
        assert.equal((await pixels(page)).hash, before.hash);
        await number.fill('0.2');
        await number.press('Tab');
        await settled(page);
        assert.match(await page.inputValue('#command'), / --roughness 0\.2/);
        await number.fill('');
        await number.press('Tab');
        await settled(page);
        assert.doesNotMatch(await page.inputValue('#command'), /--roughness/);
        await page.selectOption('#set-model', 'phong');
        await settled(page);
        assert.ok(!await page.locator('#set-roughness').isVisible());
    }),
    'an animation plays, stops and is drawn at a moment': async () => {
        const model = join(folder, 'moving.gltf');
        writeFileSync(model, JSON.stringify(movingModel()));
        const moving = await startServer(program, [model, '--env', 'studio', '--bounces', '0', '--port', '0', '--quiet']);
        const command = page => page.inputValue('#command');
        try {
            await open({ at: moving.address }, async page => {
                const before = await pixels(page);
                assert.ok(await page.locator('#animation').isVisible());
                await page.focus('#picture');
                await page.keyboard.press('Space');
                await page.waitForFunction(() => Number.parseFloat(document.getElementById('seconds').textContent) > 0.3);
                assert.equal(await page.textContent('#play'), 'Pause');
                await page.click('#play');
                await settled(page);
                assert.match(await command(page), / --animation=slide --moment=\d/);
                assert.notEqual((await pixels(page)).hash, before.hash);
                await page.locator('#moment').fill('500');
                await settled(page);
                assert.match(await command(page), / --moment=1 /);
                await page.selectOption('#animate', '-1');
                await settled(page);
                assert.doesNotMatch(await command(page), /--animation/);
                assert.equal((await pixels(page)).hash, before.hash);
            });
        } finally {
            moving.server.kill('SIGKILL');
        }
        await open({}, async page => assert.ok(!await page.locator('#animation').isVisible()));
    },
    'every control has a name': () => open({}, async page => {
        const nameless = await page.evaluate(() => [...document.querySelectorAll('input, select, textarea, button')]
            .filter(control => !control.labels?.length && !control.ariaLabel && !control.textContent.trim())
            .map(control => control.outerHTML));
        assert.deepEqual(nameless, []);
    }),
    'a saved picture is what the shown command writes': () => open({ width: 600, height: 300 }, async page => {
        await drag(page, [100, 100], [180, 140]);
        await page.selectOption('#set-tone', 'agx');
        await settled(page);
        const command = await page.inputValue('#command');
        const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-png')]);
        assert.equal(download.suggestedFilename(), 'picture.png');
        const saved = readFileSync(await download.path());
        execFileSync('/bin/sh', ['-c', command.replace(/^lambent/, `'${program}'`)], { cwd: folder });
        assert.ok(saved.equals(readFileSync(join(folder, 'picture.png'))), command);
    }),
    'three browsers at once, one of them stalled': async () => {
        await open({}, async stalled => {
            // Its page is busy for ever as far as the others can tell.
            stalled.evaluate(ms => { for (const end = performance.now() + ms; performance.now() < end;); }, 6000 * patience)
                .catch(() => {});
            await open({}, one => open({}, async two => {
                const still = await pixels(one);
                const start = Date.now();
                await drag(two, [200, 200], [280, 160]);
                assert.ok(Date.now() - start < 5000 * patience);
                assert.equal((await pixels(one)).hash, still.hash, 'each has its own camera');
                assert.notEqual((await pixels(two)).hash, still.hash);
            }));
        });
    },
    'a telephone shows picture and controls': () => open({ width: 390, height: 800, hasTouch: true, isMobile: true }, async page => {
        const picture = await page.locator('#picture').boundingBox(), panel = await page.locator('#panel').boundingBox();
        assert.ok(picture.height > 300 && panel.height > 200 && panel.y >= picture.y + picture.height - 1);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    }),
};

try {
    for (const [name, check] of Object.entries(checks)) {
        try {
            await check();
        } catch (error) {
            console.log(`FAILED ${name}`);
            throw error;
        }
        console.log(`ok ${name}`);
    }
    const ended = new Promise(done => server.once('exit', done));
    server.kill('SIGINT');
    assert.equal(await ended, 0);
    console.log('ok the server ends');
} catch (error) {
    console.error(error);
    process.exitCode = 1;
} finally {
    server.kill('SIGKILL');
    await browser.close();
    rmSync(folder, { recursive: true });
}
