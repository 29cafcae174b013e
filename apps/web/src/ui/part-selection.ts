// SPDX-License-Identifier: Apache-2.0

export interface SelectionClick {
  readonly id: number;
  /** Shift: all rows between the one that was clicked before and this one. */
  readonly isRange: boolean;
  /** Ctrl: this one more, or one less. */
  readonly isToggle: boolean;
}

/** What is selected after a click on a row. anchor: the row that was clicked before. */
export function selectionAfterClick(
  rows: readonly number[],
  selected: readonly number[],
  anchor: number | null,
  click: SelectionClick,
): number[] {
  if (click.isRange) {
    const to = rows.indexOf(click.id);
    const from = anchor === null ? -1 : rows.indexOf(anchor);
    const start = from === -1 ? to : from;
    return rows.slice(Math.min(start, to), Math.max(start, to) + 1);
  }
  if (!click.isToggle) return [click.id];
  return selected.includes(click.id)
    ? selected.filter((id) => id !== click.id)
    : [...selected, click.id];
}

/** As the action "select" takes it. */
export function selectArgument(ids: readonly number[]): string {
  return ids.join(" ");
}
