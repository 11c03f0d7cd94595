import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sameContent } from '../src/usda.js';

const PAGE = `#usda 1.0
(
    defaultPrim = "Char"
    startTimeCode = 1
    endTimeCode = 48
    customLayerData = {
        dictionary usdrigui = {
            string work = "{\\"root\\":\\"/Char\\",\\"keys\\":{\\"a\\":[[3,0.123456789]]}}"
        }
    }
)

over "Char"
{
    def SkelAnimation "Anim"
    {
        uniform token[] blendShapes = ["a, b", "b"]
        float[] blendShapeWeights.timeSamples = {
            1: [0.123456789, 1],
        }
        half3[] scales.timeSamples = {
            1: [(1.23456789, 1, 1)],
        }
    }
}
`;

/** As `Sdf.Layer.ExportToString` of usd-core 26 writes it. */
const USD = `#usda 1.0
(
    customLayerData = {
        dictionary usdrigui = {
            string work = '{"root":"/Char","keys":{"a":[[3,0.123456789]]}}'
        }
    }
    defaultPrim = "Char"
    endTimeCode = 48
    startTimeCode = 1
)

over "Char"
{
    def SkelAnimation "Anim"
    {
        uniform token[] blendShapes = ["a, b", "b"]
        float[] blendShapeWeights.timeSamples = {
            1: [0.12345679, 1],
        }
        half3[] scales.timeSamples = {
            1: [(1.23438, 1, 1)],
        }
    }
}

`;

test('a layer says the same as USD writes it', () => {
  assert.ok(sameContent(PAGE, PAGE));
  assert.ok(sameContent(PAGE, USD));
  assert.ok(sameContent(USD, PAGE));
});

test('samples, prims and comments that differ are told', () => {
  for (const [from, to] of [['0.12345679', '0.12346'], ['1.23438', '1.25'], ['Anim', 'Anima'], ['over', 'def'], ['#usda 1.0', '#usda 1.0\n# mine'], ['1: [0.1', '2: [0.1'], ['"b"]', '"b"]\n        float a = 1']]) {
    assert.ok(USD.includes(from), from);
    assert.ok(!sameContent(PAGE, USD.replace(from, to)), to);
  }
});
