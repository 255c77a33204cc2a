// What the scripts of a page find there: what the page knows of itself, and what judge.js, judge.inline.js and
// MathLive define.
declare const site: {
  paper: string; exercises: string[]; judge: boolean; mathlive: boolean; files: Record<string, string>;
};
declare const inlined: { code: string; binary: string };
declare function rederive(options: object): Promise<any>;
declare const MathfieldElement: any;
declare const mathVirtualKeyboard: any;
