// What must hold of the page as it lies there.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import {
    faintTexts, faultsOfStructure, focused, moving, openAll, overhang, smallTargets, spreadOf, wrongImages,
} from './in_page.mjs';

const widths = [390, 768, 1440], schemes = ['light', 'dark'];
const wordsOf = text => text.replace(/\s+/g, ' ').trim();

async function imagesLoad({ open, pictures }) {
    await open({}, async page => {
        assert.deepEqual(await page.evaluate(wrongImages), []);
        const sources = new Set(await page.locator('img').evaluateAll(images =>
            images.map(image => decodeURI(image.getAttribute('src')))));
        for (const { file } of pictures) assert.ok(sources.has(file), `${file} is not on the page`);
    });
}

// Some are rightly of one colour, of an exposure of thousands; most are not.
async function imagesAreNotEmpty({ open, pictures, folder }) {
    await open({}, async page => {
        let flat = 0;
        for (const { file } of pictures) {
            const kind = /\.jpe?g$/i.test(file) ? 'jpeg' : 'png';
            const bytes = readFileSync(join(folder, file)).toString('base64');
            if (await page.evaluate(spreadOf, `data:image/${kind};base64,${bytes}`) < 1) ++flat;
        }
        assert.ok(flat <= pictures.length / 4, `${flat} of ${pictures.length} pictures are of one colour`);
    });
}

async function structure({ open }) {
    await open({}, async page => assert.deepEqual(await page.evaluate(faultsOfStructure), []));
}

async function contrast({ open }) {
    for (const scheme of schemes)
        for (const width of [390, 1440])
            await open({ width, scheme }, async page => {
                await page.evaluate(openAll);
                const { count, faint } = await page.evaluate(faintTexts);
                assert.ok(count > 10, `${count} texts seen`);
                assert.deepEqual(faint, [], `${scheme}, ${width}`);
                await page.locator('.view').first().click();
                await page.evaluate(openAll);
                assert.deepEqual((await page.evaluate(faintTexts)).faint, [], `${scheme}, the viewer`);
            });
}

async function noSidewaysScroll({ open }) {
    for (const width of widths)
        await open({ width }, async page => {
            assert.ok(await page.evaluate(overhang) <= 0, `${width}`);
            await page.evaluate(openAll);
            assert.ok(await page.evaluate(overhang) <= 0, `${width} with all details open`);
            await page.locator('.view').first().click();
            assert.ok(await page.evaluate(() => {
                const viewer = document.getElementById('viewer');
                return viewer.scrollWidth <= innerWidth && viewer.scrollHeight <= innerHeight;
            }), `${width}: the viewer is larger than the window`);
        });
}

async function targets({ open }) {
    await open({ width: 390, height: 844 }, async page => {
        await page.evaluate(openAll);
        await page.locator('.folded summary').click();
        assert.deepEqual(await page.evaluate(smallTargets), []);
    });
}

async function focusIsSeen({ open }) {
    await open({}, async page => {
        await page.keyboard.press('Tab');
        assert.match((await page.evaluate(focused)).html, /class="skip"/);
        for (let stop = await page.evaluate(focused), count = 0; stop && count < 1000; ++count) {
            assert.ok(stop.isSeen, `${stop.html} shows no focus`);
            await page.keyboard.press('Tab');
            stop = await page.evaluate(focused);
        }
    });
}

async function skipLink({ open }) {
    await open({}, async page => {
        await page.keyboard.press('Tab');
        await page.keyboard.press('Enter');
        assert.equal(await page.evaluate(() => document.activeElement.querySelectorAll('h1').length), 1);
    });
}

async function stillness({ open }) {
    await open({ reducedMotion: 'reduce' }, async page => assert.deepEqual(await page.evaluate(moving), []));
}

// The texts that a reader without the script must find.
function textsOf({ report, pictures }) {
    const figures = report.sections.flatMap(section => section.figures);
    return [report.title, report.lead,
        ...report.sections.flatMap(section => [section.title, ...section.text]),
        ...figures.flatMap(figure => [figure.title, figure.caption, ...(figure.rows ?? []).flat(),
            ...(figure.columns ?? []), ...(figure.curves ?? []).map(curve => curve.name)]),
        ...pictures.flatMap(picture => picture.numbers.flatMap(({ name, value }) => [name, value])),
        ...report.facts.flatMap(({ name, value }) => [name, value])];
}

async function withoutScript({ open, report, pictures }) {
    for (const width of [390, 1440])
        await open({ width, javaScriptEnabled: false }, async page => {
            const images = page.locator('img');
            assert.equal(await images.count(), pictures.length);
            for (let i = 0; i < pictures.length; ++i)
                assert.ok(await images.nth(i).isVisible(), pictures[i].file);
            const commands = new Set(await page.locator('code').allTextContents());
            for (const command of pictures.flatMap(picture => picture.commands))
                assert.ok(commands.has(command), command);
            const text = wordsOf(await page.locator('body').textContent());
            for (const part of textsOf({ report, pictures })) assert.ok(text.includes(wordsOf(part)), part);
            await page.locator('.made > summary').first().click();
            assert.ok(await page.locator('.made code').first().isVisible());
            assert.equal(await page.locator('button:visible').count(), 0, 'a button that can do nothing');
        });
}

export const pageChecks = {
    'every picture loads, in its size': imagesLoad,
    'pictures hold something': imagesAreNotEmpty,
    'headings, names and alternatives': structure,
    'contrast of texts in light and dark': contrast,
    'no sideways scrolling': noSidewaysScroll,
    'targets for fingers': targets,
    'the focus can be seen everywhere': focusIsSeen,
    'the skip link': skipLink,
    'stillness for who wants it': stillness,
    'all there without JavaScript': withoutScript,
};
