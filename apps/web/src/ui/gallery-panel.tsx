// SPDX-License-Identifier: Apache-2.0
import { examples, type Example } from "../files/examples";
import "../styles/gallery-panel.css";
import { ExampleCard } from "./example-card";
import { Panel } from "./panel";
import { useStudio } from "./studio-context";

interface ShelfProps {
  readonly title: string;
  readonly hint?: string;
  readonly shown: readonly Example[];
  readonly isFirst?: boolean;
  readonly onOpen: () => void;
}

function Shelf({ title, hint, shown, isFirst = false, onOpen }: ShelfProps) {
  return (
    <section class="gallery-shelf">
      <h3>{title}</h3>
      {hint !== undefined && <p>{hint}</p>}
      <ul>
        {shown.map((example, index) => (
          <li key={example.id}>
            <ExampleCard example={example} onOpen={onOpen} isFirst={isFirst && index === 0} />
          </li>
        ))}
      </ul>
    </section>
  );
}

/** Drawings of our own, to look into and to go on with. Opening one can be undone. */
export function GalleryPanel() {
  const studio = useStudio();
  const close = () => {
    studio.panel.value = null;
  };
  return (
    <Panel title={studio.word("examples")} onClose={close} place="middle" isLarge>
      <Shelf
        title={studio.word("examples_rough")}
        hint={studio.word("examples_rough_hint")}
        shown={examples.filter(({ isRough }) => isRough)}
        isFirst
        onOpen={close}
      />
      <Shelf
        title={studio.word("examples_finished")}
        shown={examples.filter(({ isRough }) => !isRough)}
        onOpen={close}
      />
      <p class="gallery-licence">{studio.word("examples_licence")}</p>
    </Panel>
  );
}
