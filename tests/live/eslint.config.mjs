// What the interpreter and its tests are held to: eslint's own list, and some of its rules more. What is not defined TypeScript's
// checker tells of the interpreter, whose files are one script.   eslint -c tests/live/eslint.config.mjs FILE…
import js from '@eslint/js';

const more = {
    'eqeqeq': 'error', 'no-eval': 'error', 'no-implied-eval': 'error', 'no-new-func': 'error', 'no-script-url': 'error',
    'no-var': 'error', 'prefer-const': 'error', 'object-shorthand': 'error', 'no-shadow': ['error', {builtinGlobals: false}],
    'no-implicit-coercion': 'error', 'no-throw-literal': 'error', 'no-unused-vars': ['error', {vars: 'local'}], 'no-undef': 'off',
};
export default [
    js.configs.recommended,
    {files: ['**/*.js'], languageOptions: {sourceType: 'module'}, rules: more},
    {files: ['**/*.mjs'], rules: more},
];
