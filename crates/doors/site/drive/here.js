// Where the machine of this page is: in the program that serves it.

export { SocketHome as Here } from "./socket-home.js";

/** What the instrument shows where its address says nothing: the path's first frame of the program's scenario, and two of its wires. */
export const FIRST = { frame: 0, set: {}, faults: [] };

/** Whether the books of the documentation lie beside these pages. */
export const HAS_BOOKS = false;

/** Whether files of the reader can be opened. */
export const TAKES_FILES = false;
