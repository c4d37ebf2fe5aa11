// SPDX-License-Identifier: BSL-1.0

const indent = '  ';

/** Replaces the selection, so that the reader can undo it. */
function insert(editor, text) {
  if (!document.execCommand('insertText', false, text)) {
    editor.setRangeText(text, editor.selectionStart, editor.selectionEnd, 'end');
  }
}

function select_whole_lines(editor) {
  const { value, selectionStart, selectionEnd } = editor;
  const start = value.lastIndexOf('\n', selectionStart - 1) + 1;
  const ends = value.indexOf('\n', Math.max(selectionStart, selectionEnd - 1));
  editor.setSelectionRange(start, ends < 0 ? value.length : ends);
}

function change_lines(editor, change) {
  select_whole_lines(editor);
  const { selectionStart, selectionEnd, value } = editor;
  const lines = value.slice(selectionStart, selectionEnd).split('\n').map(change).join('\n');
  insert(editor, lines);
  editor.setSelectionRange(selectionStart, selectionStart + lines.length);
}

/** Tab indents, and Shift+Tab takes an indent away. After Escape, Tab moves to the next control. */
export function make_editor(editor) {
  let leaves = false;
  editor.addEventListener('blur', () => { leaves = false; });
  editor.addEventListener('keydown', (event) => {
    const is_tab = event.key === 'Tab' && !event.ctrlKey && !event.altKey && !event.metaKey;
    if (is_tab && !leaves) {
      event.preventDefault();
      if (event.shiftKey) {
        change_lines(editor, (line) => line.replace(/^ {1,2}/, ''));
      } else if (editor.selectionStart === editor.selectionEnd) {
        insert(editor, indent);
      } else {
        change_lines(editor, (line) => indent + line);
      }
    }
    if (event.key !== 'Shift') {
      leaves = event.key === 'Escape' || (is_tab && leaves);
    }
  });
}

/** Selects a line, counted from 1, and scrolls to it. */
export function show_line(editor, line) {
  const lines = editor.value.split('\n');
  const start = lines.slice(0, line - 1).join('\n').length + (line > 1 ? 1 : 0);
  editor.focus();
  editor.setSelectionRange(start, start + (lines[line - 1] ?? '').length);
  editor.scrollTop = (line - 1) * (editor.scrollHeight / lines.length) - editor.clientHeight / 2;
}
