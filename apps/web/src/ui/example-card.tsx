// SPDX-License-Identifier: Apache-2.0
import { openExample, type Example } from "../files/examples";
import "../styles/example-card.css";
import { useStudio } from "./studio-context";

interface ExampleCardProps {
  readonly example: Example;
  /** Called when it was chosen. */
  readonly onOpen?: () => void;
  readonly isFirst?: boolean;
}

/** Picture and name of an example; a press opens it. */
export function ExampleCard({ example, onOpen, isFirst = false }: ExampleCardProps) {
  const studio = useStudio();
  const open = () => {
    void openExample(studio, example);
    onOpen?.();
  };
  return (
    <button
      type="button"
      class="example-card"
      data-first-focus={isFirst ? "" : undefined}
      onClick={open}
    >
      <img
        src={example.picture}
        alt=""
        width={240}
        height={240}
        loading="lazy"
        decoding="async"
        draggable={false}
      />
      <span>{studio.word(example.name)}</span>
    </button>
  );
}
