// The workbench's edits of a file's text, without a browser: what is edited changes, every other byte stays.
// node workbench_text_test.mjs EXAMPLES
import assert from 'node:assert/strict';
import {readFileSync, readdirSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {compiled} from '../../web/compiled.mjs';

const {
    Edit, JsonText, Model, NotJson, distance, fragmentOf, mostBytes, places, plain, removeBody, removePoint, rename,
    setAngle, setDistance, textOf
} = await compiled(...['edit', 'json_text', 'link', 'model', 'placing', 'references'].map((name) => `src/${name}.ts`));

const [examples] = process.argv.slice(2);
const files = readdirSync(examples, {recursive: true})
    .map((each) => join(examples, each))
    .filter((each) => each.endsWith('.json') && statSync(each).isFile())
    .map((path) => ({path, text: readFileSync(path, 'utf8')}));
const fourBar = readFileSync(join(examples, 'four_bar.json'), 'utf8');
const spotsOf = {O2: [0, 0], A: [20, 34.64], O4: [150, 0], B: [163.33, 78.88]};
const edit = (text = fourBar) => new Edit(new JsonText(text), spotsOf);

test('every example is read as the language reads it', () => {
    assert.ok(files.length > 80);
    for (const {path, text} of files) assert.deepEqual(plain(new JsonText(text).root), JSON.parse(text), path);
});
test('what is no JSON is refused where JSON.parse refuses it', () => {
    const broken = [
        '',
        '{',
        '[1,]',
        '{"a" 1}',
        '{"a": 01}',
        '"\u0001"',
        '{"a": 1}}',
        'nul',
        '{"a": .5}',
        '"\\x"',
        '[1 2]',
        '{a: 1}',
        '+1'
    ];
    for (const each of broken) {
        assert.throws(() => JSON.parse(each));
        assert.throws(() => new JsonText(each), NotJson, each);
    }
    assert.throws(() => new JsonText('['.repeat(1e5)), NotJson);
});
test('setting a value to itself changes no byte; another changes that value alone', () => {
    for (const {path, text} of files) {
        const json = new JsonText(text);
        if (json.root.kind !== 'object') continue;
        for (const {name} of new Model(json).points) {
            const at = ['points', name], raw = json.rawAt(at), changed = json.set(at, [1, 2]);
            assert.equal(changed.text.replace('[1, 2]', () => raw), text, path);
            assert.deepEqual(changed.plainAt(at), [1, 2]);
        }
    }
});
test('a member that is added and removed leaves the text as it was', () => {
    for (const {path, text} of files) {
        const json = new JsonText(text), list = json.at(['joints']);
        if (json.at(['points'])?.members.length > 0) {
            const more = json.set(['points', 'new'], [0, 0]);
            assert.deepEqual(more.plainAt(['points', 'new']), [0, 0]);
            assert.equal(more.remove(['points', 'new']).text, text, path);
        }
        if (list?.items.length > 0)
            assert.equal(
                json.add(['joints'], {revolute: 'A', bodies: [1, 2]}).remove(['joints', list.items.length]).text,
                text,
                path
            );
    }
});
test('renaming there and back is no change, and leaves no old name behind', () => {
    let renamed = 0;
    for (const {path, text} of files) {
        const model = new Model(new JsonText(text));
        for (const [kind, list] of [['point', model.points], ['body', model.bodies]]) {
            for (const {name} of list) {
                const there = new Edit(new JsonText(text), {}), named = places(there, kind, name);
                if (!rename(there, kind, name, 'renamed')) continue;
                assert.deepEqual(places(there, kind, name), [], path);
                assert.ok(rename(there, kind, 'renamed', name));
                assert.deepEqual(places(there, kind, name), named, path);
                // A body's number may be written 2 or "2".
                if (kind === 'point') assert.equal(there.text, text, `${path} ${name}`);
                ++renamed;
            }
        }
    }
    assert.ok(renamed > 300, String(renamed));
});
test('a length that is typed becomes the form of the file: a distance, then the meet of two circles', () => {
    const begun = new Edit(
        new JsonText(
            '{"points": {"O": [0, 0], "A": [3, 4], "C": [9, 0]}, "bodies": {"1": ["O", "C"]}, "frame": 1, "joints": []}'
        ),
        {O: [0, 0], A: [3, 4], C: [9, 0]}
    );
    assert.ok(setDistance(begun, 'O', 'A', 6));
    assert.deepEqual(begun.json.plainAt(['points', 'A']), {from: 'O', distance: 6, angle: 53.1301});
    assert.ok(setDistance(begun, 'A', 'C', '= 2*r'));
    assert.deepEqual(begun.json.plainAt(['points', 'A']), {
        meet: [
            {circle: 'O', radius: 6},
            {circle: 'C', radius: '= 2*r'}
        ],
        side: 'left'
    });
    assert.ok(setDistance(begun, 'C', 'A', 7));
    assert.equal(begun.json.plainAt(['points', 'A', 'meet', 1, 'radius']), 7);
    setAngle(begun, 'O', 'A', 30);
    assert.equal(begun.json.plainAt(['points', 'A', 'angle']), 30);
    assert.equal(distance([0, 0], [3, 4]), 5);
});
test('what is deleted takes with it what cannot stand alone, and nothing else', () => {
    const point = edit();
    removePoint(point, 'A');
    assert.deepEqual(point.model.points.map(({name}) => name), ['O2', 'O4', 'B']);
    assert.deepEqual(point.model.bodies.map(({name}) => name), ['4']);
    assert.deepEqual(point.model.joints.map((each) => each.point), ['O4']);
    assert.equal(point.json.at(['drivers']), undefined);
    assert.deepEqual(point.json.plainAt(['points', 'B']), [163.33, 78.88]);
    const body = edit();
    removeBody(body, '3');
    assert.deepEqual(body.model.joints.map((each) => each.point), ['O2', 'O4']);
    assert.deepEqual(body.json.plainAt(['drivers']), [{body: 2, omega: '-120 rpm'}]);
});
test('a link holds the file; one that is damaged, huge or foreign holds nothing', async () => {
    for (const {text} of files) assert.equal(await textOf(await fragmentOf(text)), text.replace(/^\uFEFF/, ''));
    assert.equal(await textOf(await fragmentOf(' '.repeat(mostBytes + 1))), null);
    for (const each of ['', '#', '#m=', '#m=!', '#m=AAAA', '#m=%00', `#m=${'A'.repeat(1e6)}`, '#x=S0xKBgA'])
        assert.ok([null, ''].includes(await textOf(each)), each);
});
