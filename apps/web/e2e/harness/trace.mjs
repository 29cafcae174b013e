// SPDX-License-Identifier: Apache-2.0
// What the browser's own trace tells of the threads of a page.

const categories = ["toplevel", "disabled-by-default-devtools.timeline", "devtools.timeline"];

function threadsOf(events) {
  const names = new Map();
  for (const event of events) {
    if (event.name === "thread_name") names.set(`${event.pid} ${event.tid}`, event.args.name);
  }
  return names;
}

/**
 * Does something and tells of each thread of the page's process the longest task, ms of processor time: without a GPU, and beside other
 * programs, the clock mostly tells how long the thread waited for its turn, or for the process that paints.
 * @returns {Promise<{main: number[], worker: number[]}>} longest first
 */
export async function tasksDuring(browser, page, doing) {
  await browser.startTracing(page, { categories });
  await doing();
  const { traceEvents } = JSON.parse(String(await browser.stopTracing()));
  const threads = threadsOf(traceEvents);
  const tasks = (name) =>
    traceEvents
      .filter((event) => event.tdur !== undefined && /RunTask$/.test(event.name))
      .filter((event) => threads.get(`${event.pid} ${event.tid}`)?.includes(name))
      .map((event) => event.tdur / 1000)
      .sort((a, b) => b - a);
  return { main: tasks("CrRendererMain"), worker: tasks("DedicatedWorker") };
}
