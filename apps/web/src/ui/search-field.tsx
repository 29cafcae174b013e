// SPDX-License-Identifier: Apache-2.0
import { Search } from "lucide-preact";
import "../styles/controls.css";

interface SearchFieldProps {
  readonly label: string;
  readonly value: string;
  readonly onValue: (value: string) => void;
}

/** A field that filters what stands below it. */
export function SearchField({ label, value, onValue }: SearchFieldProps) {
  return (
    <label class="search-field">
      <Search size={16} aria-hidden="true" />
      <input
        type="search"
        aria-label={label}
        placeholder={label}
        value={value}
        autocomplete="off"
        spellcheck={false}
        onInput={(event) => {
          onValue(event.currentTarget.value);
        }}
      />
    </label>
  );
}
