// Opens a page of the report in Chromium and checks that it works for whoever comes to it. The folder holds
// index.html and report.json. node browser.mjs FOLDER
// One line for each check, stops at the first that fails. Exits with 77, which skips the test, where the
// browser or its package is missing; with LAMBENT_REQUIRE_BROWSER in the environment it fails instead.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { pageChecks } from './page_checks.mjs';
import { useChecks } from './use_checks.mjs';

function missing(what) {
    const isRequired = Boolean(process.env.LAMBENT_REQUIRE_BROWSER);
    console.log(`${isRequired ? 'missing' : 'skipped'}: ${what}`);
    process.exit(isRequired ? 1 : 77);
}

// A browser that can be killed when it no longer answers: { browser, kill() }.
async function startBrowser() {
    let playwright;
    try {
        playwright = await import('playwright-core');
    } catch (error) {
        if (error.code !== 'ERR_MODULE_NOT_FOUND') throw error;
        missing('no playwright-core; `node tests/support/fetch.mjs tests/report` gets it');
    }
    const places = [process.env.CHROMIUM ?? '', '/usr/bin/chromium', '/usr/bin/chromium-browser'];
    const executablePath = places.find(existsSync);
    if (!executablePath) missing('no Chromium (Debian package chromium)');
    // Chromium's sandbox does not start for root.
    const args = process.getuid() === 0 ? ['--no-sandbox'] : [];
    const server = await playwright.chromium.launchServer({ executablePath, args });
    return { browser: await playwright.chromium.connect(server.wsEndpoint()), kill: () => server.kill() };
}

// The most that a check takes before its browser counts as hung. All checks together take about a minute.
const patience = 150e3;

// Whether the check ended in time. Throws what it throws.
async function endsInTime(check) {
    let timer;
    const late = new Promise(resolve => { timer = setTimeout(resolve, patience, false); });
    try {
        return await Promise.race([check.then(() => true), late]);
    } finally {
        clearTimeout(timer);
    }
}

// Runs a check in a browser of its own. Chromium has been seen to stop for good: the check is then
// run once more, in a new one.
async function run(name, check, address, subject) {
    for (const attempt of [1, 2]) {
        const { browser, kill } = await startBrowser();
        const running = check({ ...subject, open: opener(browser, address) });
        running.catch(() => {}); // of a killed browser
        try {
            if (await endsInTime(running)) return;
        } finally {
            await kill();
        }
        console.log(`hung, attempt ${attempt}: ${name}`);
    }
    throw new Error(`${name}: the browser hung twice`);
}

// What must never happen on a page, as it happens.
function troublesOf(page) {
    const troubles = [];
    page.on('console', message => {
        if (['error', 'warning'].includes(message.type())) troubles.push(`console: ${message.text()}`);
    });
    page.on('pageerror', error => troubles.push(`script: ${error.message}`));
    page.on('requestfailed', request => {
        // Of a page that is left while it loads.
        if (request.failure().errorText !== 'net::ERR_ABORTED') troubles.push(`failed: ${request.url()}`);
    });
    page.on('request', request => {
        if (!/^(file|data):/.test(request.url())) troubles.push(`asked for ${request.url()}`);
    });
    return troubles;
}

// Calls use(page) with a fresh page: { width, height, scheme, ...what Playwright's newContext takes }.
function opener(browser, address) {
    return async ({ width = 1440, height = 900, scheme = 'light', prepare, ...options }, use) => {
        const viewport = { width, height };
        const context = await browser.newContext({ viewport, colorScheme: scheme, ...options });
        const page = await context.newPage(), troubles = troublesOf(page);
        if (prepare) await page.addInitScript(prepare);
        await page.goto(address);
        await use(page, context);
        assert.deepEqual(troubles, []);
        await context.close();
    };
}

// Every picture of the report in the page's order, with the figure it is in.
function picturesOf(report) {
    const figures = report.sections.flatMap(section => section.figures);
    const inFigures = figures.flatMap(figure =>
        (figure.pictures ?? []).map(picture => ({ ...picture, figure })));
    return [...(report.cover.file ? [report.cover] : []), ...inFigures];
}

if (Number(process.versions.node.split('.')[0]) < 18) missing('no Node.js 18 or later');
const folder = resolve(process.argv[2]);
const report = JSON.parse(readFileSync(join(folder, 'report.json')));
const address = pathToFileURL(join(folder, 'index.html')).href;
const subject = { folder, report, pictures: picturesOf(report) };
try {
    for (const [name, check] of Object.entries({ ...pageChecks, ...useChecks })) {
        try {
            await run(name, check, address, subject);
        } catch (error) {
            console.log(`FAILED ${name}`);
            throw error;
        }
        console.log(`ok ${name}`);
    }
} catch (error) {
    console.error(error);
    process.exitCode = 1;
}
process.exit(); // whatever a killed browser left waiting
