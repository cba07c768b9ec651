// What scripts and their tests are held to: eslint's own list, that of typescript-eslint for TypeScript, and some of
// their rules more. What is not defined TypeScript's checker tells of the interpreter, whose files are one script.
// eslint -c tests/live/eslint.config.mjs FILE…
import js from '@eslint/js';
import {fileURLToPath} from 'node:url';
import typescript from 'typescript-eslint';

const more = {
    'eqeqeq': 'error', 'no-eval': 'error', 'no-implied-eval': 'error', 'no-new-func': 'error', 'no-script-url': 'error',
    'no-var': 'error', 'prefer-const': 'error', 'object-shorthand': 'error', 'no-shadow': ['error', {builtinGlobals: false}],
    'no-implicit-coercion': 'error', 'no-throw-literal': 'error', 'no-unused-vars': ['error', {vars: 'local'}], 'no-undef': 'off',
};
/** Of types: what a script that only looks at one file at a time cannot find. */
const typed = {
    '@typescript-eslint/no-unused-vars': ['error', {argsIgnorePattern: '^_'}],
    '@typescript-eslint/consistent-type-imports': ['error', {fixStyle: 'inline-type-imports'}],
    '@typescript-eslint/no-floating-promises': 'error', '@typescript-eslint/no-misused-promises': 'error',
    '@typescript-eslint/no-unnecessary-type-assertion': 'error', '@typescript-eslint/switch-exhaustiveness-check': 'error',
    'no-unused-vars': 'off',
};
export default [
    {ignores: ['**/node_modules/']},
    js.configs.recommended,
    {files: ['**/*.js'], languageOptions: {sourceType: 'module'}, rules: more},
    {files: ['**/*.mjs'], rules: more},
    ...typescript.configs.recommended.map((each) => ({...each, files: ['web/**/*.ts']})),
    {
        files: ['web/**/*.ts'],
        languageOptions: {
            parserOptions: {project: fileURLToPath(new URL('../../web/tsconfig.json', import.meta.url))},
        },
        rules: {...more, ...typed},
    },
];
