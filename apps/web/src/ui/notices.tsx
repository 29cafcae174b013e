// SPDX-License-Identifier: Apache-2.0
import { CircleCheck, OctagonAlert, TriangleAlert, X } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import type { Notice } from "../studio/studio";
import type { Word } from "../studio/words";
import "../styles/controls.css";
import "../styles/notices.css";
import {
  type Countdown,
  holdCountdown,
  resumeCountdown,
  shownForMs,
  startCountdown,
  timeLeft,
} from "./notice-timing";
import { useStudio } from "./studio-context";

const looks: Readonly<Record<Notice["severity"], readonly [typeof X, Word]>> = {
  status: [CircleCheck, "severity_status"],
  warning: [TriangleAlert, "severity_warning"],
  problem: [OctagonAlert, "severity_problem"],
};

/** Puts a notice away when its time is over; the time stands still while the notice is held. */
function useTimedDismissal(notice: Notice, isHeld: boolean, dismiss: () => void): void {
  const countdown = useRef<Countdown | null>(null);
  const onOver = useRef(dismiss);
  onOver.current = dismiss;

  useEffect(() => {
    const totalMs = shownForMs(notice);
    if (totalMs === null) return;
    const nowMs = performance.now();
    countdown.current ??= startCountdown(totalMs, nowMs);
    if (isHeld) {
      countdown.current = holdCountdown(countdown.current, nowMs);
      return;
    }
    countdown.current = resumeCountdown(countdown.current, nowMs);
    const timer = setTimeout(
      () => {
        onOver.current();
      },
      timeLeft(countdown.current, nowMs),
    );
    return () => {
      clearTimeout(timer);
    };
  }, [notice, isHeld]);
}

function NoticeCard({ notice, isHeld }: { readonly notice: Notice; readonly isHeld: boolean }) {
  const studio = useStudio();
  const { id, place, remedy } = notice;
  const dismiss = () => {
    studio.dismiss(id);
  };
  useTimedDismissal(notice, isHeld, dismiss);
  const [Icon, severity] = looks[notice.severity];
  return (
    <li class="notice" data-severity={notice.severity}>
      <Icon size={18} aria-hidden="true" />
      <p class="notice-text">
        <span class={notice.severity === "status" ? "visually-hidden" : "notice-severity"}>
          {studio.word(severity)}{" "}
        </span>
        {notice.text}
      </p>
      {place !== null && (
        <button
          type="button"
          class="notice-button"
          onClick={() => {
            studio.showPlace(place);
          }}
        >
          {studio.word("show")}
        </button>
      )}
      {remedy !== null && (
        <button
          type="button"
          class="notice-button"
          onClick={() => {
            remedy.run();
            dismiss();
          }}
        >
          {remedy.label}
        </button>
      )}
      <button
        type="button"
        class="notice-close"
        aria-label={studio.word("dismiss")}
        onClick={dismiss}
      >
        <X size={16} aria-hidden="true" />
      </button>
    </li>
  );
}

/** What the studio has to say; nobody has to answer to go on drawing. */
export function Notices() {
  const studio = useStudio();
  const notices = studio.notices.value;
  const [isPointedAt, setIsPointedAt] = useState(false);
  const [hasFocus, setHasFocus] = useState(false);

  // An emptied list gets neither pointerleave nor blur.
  const isEmpty = notices.length === 0;
  useEffect(() => {
    if (!isEmpty) return;
    setIsPointedAt(false);
    setHasFocus(false);
  }, [isEmpty]);

  if (isEmpty) return null;
  return (
    <section
      class="notices"
      aria-label={studio.word("notices")}
      onPointerEnter={() => {
        setIsPointedAt(true);
      }}
      onPointerLeave={() => {
        setIsPointedAt(false);
      }}
      onFocusIn={() => {
        setHasFocus(true);
      }}
      onFocusOut={() => {
        setHasFocus(false);
      }}
    >
      <ul>
        {notices.map((notice) => (
          <NoticeCard key={notice.id} notice={notice} isHeld={isPointedAt || hasFocus} />
        ))}
      </ul>
    </section>
  );
}

/** Reads out what the studio says. It is always there: a region that comes with its words is often passed over. */
export function StatusLine() {
  const studio = useStudio();
  const latest = studio.notices.value.at(-1);
  const isProblem = latest?.severity === "problem";
  // A new element for each: the same words twice are said twice.
  const spoken = latest !== undefined && <span key={latest.id}>{latest.text}</span>;
  return (
    <div class="visually-hidden">
      <div role="status">{!isProblem && spoken}</div>
      <div role="alert">{isProblem && spoken}</div>
    </div>
  );
}
