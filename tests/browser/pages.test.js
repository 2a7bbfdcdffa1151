// The pages as people use them. run.sh makes them and says where they are.
import assert from "node:assert/strict";
import { readFileSync, statSync, mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, before, test } from "node:test";

const folder = process.env.TESTAT_BROWSER_FOLDER;
const require = createRequire(join(folder, "package.json"));
const { chromium } = require("playwright-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const file_of = name => join(folder, "pages", name);
const reports = ["wrong", "right", "all_wrong", "broken", "hostile"].map(name => `${name}/report.html`);
const all_pages = [...reports, "overview.html", "hostile.html"];
const widths = [360, 768, 1440];
const patience = 120_000;  // milliseconds; the machine may have other things to do

let browser;
before(async () => {
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--force-prefers-reduced-motion"],
  });
  mkdirSync(join(folder, "screenshots"), { recursive: true });
});
after(() => browser?.close());

// A page, and what went on in it: requests but for itself and data, errors, calls of owned().
const open = async (name, options = {}) => {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  const seen = { requests: [], errors: [], owned: [] };
  await page.exposeFunction("owned", number => { seen.owned.push(number); });
  page.on("request", request => {
    if (!request.url().startsWith("data:") && !request.isNavigationRequest()) seen.requests.push(request.url());
  });
  page.on("pageerror", error => seen.errors.push(String(error)));
  page.on("dialog", dialog => { seen.owned.push(dialog.message()); dialog.dismiss(); });
  await page.goto("file://" + file_of(name));
  return { page, seen, close: () => context.close() };
};

const with_page = async (name, options, look) => {
  const opened = await open(name, options);
  try {
    await look(opened.page, opened.seen);
  } finally {
    await opened.close();
  }
};

for (const name of all_pages)
  test(`${name} asks for nothing and has no errors`, () => with_page(name, {}, async (page, seen) => {
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    assert.deepEqual(seen.errors, []);
    assert.deepEqual(seen.requests, []);
  }));

// What axe finds, as texts. It copies elements as they stand, so long pictures would cost it minutes.
const violations_of = async (page, width) => {
  await page.evaluate(() => { for (const image of document.images) image.src = "data:image/gif;base64,R0lGODlhAQABAAAAACw="; });
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => axe.run({ resultTypes: ["violations"] }));
  return violations.map(v => `${width}: ${v.id}: ${v.nodes.slice(0, 3).map(n => n.html.slice(0, 200)).join(" ")}`);
};

for (const name of all_pages)
  test(`${name} has no accessibility violations, is never wider than the window`, () => with_page(name, {}, async page => {
    if (name === "overview.html")  // a few rows are like a thousand
      await page.evaluate(() => document.querySelectorAll("tbody tr:nth-child(n+30), .who li:nth-child(n+30)").forEach(row => row.remove()));
    const looked_at_everywhere = ["wrong/report.html", "overview.html"].includes(name);
    for (const [i, width] of widths.entries()) {
      await page.setViewportSize({ width, height: 800 });
      await page.emulateMedia({ colorScheme: i === 1 ? "dark" : "light" });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(wide <= 0, `${wide} pixels too wide at ${width}`);
      if (!looked_at_everywhere && (i !== 1 || name === "all_wrong/report.html")) continue;  // more of the same
      await page.screenshot({ path: join(folder, "screenshots", `${name.replace(/(\/report)?\.html/, "")}-${width}.png`) });
      assert.deepEqual(await violations_of(page, width), []);
    }
  }));

for (const name of ["hostile/report.html", "hostile.html"])
  test(`${name} runs nothing of an upload's`, () => with_page(name, {}, async (page, seen) => {
    for (const details of await page.locator("details").all()) await details.evaluate(d => { d.open = true; });
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    await page.waitForTimeout(200);
    assert.deepEqual(seen.owned, []);
    const found = await page.evaluate(() => ({
      scripts: document.scripts.length,
      styles: document.querySelectorAll("style").length,
      handlers: [...document.querySelectorAll("*")].filter(e => [...e.attributes].some(a => a.name.startsWith("on"))).length,
      addresses: [...document.links].map(a => a.getAttribute("href")).filter(h => !/^(#|reports\/|similarity\.txt)/.test(h)),
      text: document.body.textContent,
    }));
    assert.deepEqual([found.scripts, found.styles, found.handlers, found.addresses], [1, 1, 0, []]);
    assert.ok(found.text.includes("<script>owned("), "shown as text");
    assert.ok(found.text.includes("{{{script}}}"), "no template either");
  }));

test("the policy forbids a script that got in all the same", () => with_page("wrong/report.html", {}, async (page, seen) => {
  await page.evaluate(() => {
    for (const html of ["<img src=x onerror=owned(1)>", "<iframe srcdoc='<script>parent.owned(3)</script>'></iframe>"])
      document.body.insertAdjacentHTML("beforeend", html);
    const script = document.createElement("script");
    script.textContent = "owned(2)";
    document.body.append(script);
  });
  await page.waitForTimeout(200);
  assert.deepEqual(seen.owned, []);
}));

test("what to fix first is on the first screen, with what is wrong and what to do", async () => {
  for (const [width, height] of [[1440, 768], [768, 1024], [360, 740]])
    await with_page("wrong/report.html", { viewport: { width, height } }, async page => {
      const first = page.locator(".first");
      const box = await first.boundingBox();
      assert.ok(box.y + box.height <= height, `ends at ${box.y + box.height} of ${height}`);
      const text = await first.innerText();
      for (const part of ["Zuerst beheben", "evaluate_bilinear", "s = u * W - 0.5"]) assert.ok(text.includes(part), `${part} in ${text}`);
    });
});

test("the language changes, with the keyboard, too", () => with_page("wrong/report.html", {}, async page => {
  const heading = page.locator("#tasks");
  assert.equal(await heading.innerText(), "Punkte nach Aufgabe und Funktion");
  await page.locator("#lang-de").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await heading.innerText(), "Points by task and function");
  assert.equal(await page.evaluate(() => document.documentElement.lang), "en");
}));

test("without JavaScript everything is there", () => with_page("wrong/report.html", { javaScriptEnabled: false }, async page => {
  await page.getByText("English").click();
  const text = await page.locator("main").innerText();
  for (const part of ["Fix this first", "val = -23, size = 6", "Came out", "Expected", "abs(val % size)", "unused variable",
                      "--tasks b", "Pictures that differ (3)"])
    assert.ok(text.includes(part), part);
  const first = page.locator(".picture").first();
  assert.equal(await first.locator("img").count(), 3, "mine, expected, difference");
  for (const image of await first.locator("img").all())
    assert.ok(await image.evaluate(i => i.naturalWidth) > 0);
  assert.equal(await page.locator(".compare:visible, .loupe:visible").count(), 0);
  await page.locator("details#f-wrap_clamp summary").click();
  assert.ok(await page.locator("details#f-wrap_clamp .code").isVisible());
}));

test("the slider shows more of one picture or the other", () => with_page("wrong/report.html", {}, async page => {
  const card = page.locator(".picture").first();
  await card.scrollIntoViewIfNeeded();
  const slider = card.locator("input[type=range]");
  await slider.waitFor();
  const clip = () => card.locator(".over").evaluate(image => image.style.clipPath);
  assert.match(await clip(), /50%/);
  await slider.focus();
  await page.keyboard.press("Home");
  assert.match(await clip(), /100%/);
  await page.keyboard.press("End");
  assert.match(await clip(), /inset\(0(px|%)?( 0(px|%)?)*\)/);
}));

test("the loupe says the values of a pixel", () => with_page("wrong/report.html", {}, async page => {
  const card = page.locator(".picture").first();
  await card.scrollIntoViewIfNeeded();
  await card.locator(".loupe").waitFor();
  const values = async () => Promise.all(["a", "b", "d"].map(c => card.locator(`output.${c}`).innerText()));
  const [a, b, d] = await values();
  assert.match(a, /^\d+ \d+ \d+$/);
  assert.ok(Number(d) > 0, "it begins where they differ most");
  await card.locator("input.x").fill("3");
  await card.locator("input.y").fill("250");
  const [mine, theirs, none] = await values();
  assert.equal(mine, theirs);
  assert.equal(none, "0");
  await card.locator(".mine img").hover({ position: { x: 40, y: 20 } });
  assert.notEqual(await card.locator("input.y").inputValue(), "250");
  const shown = await page.evaluate(() => {
    const canvas = document.querySelector(".difference canvas");
    return [...canvas.getContext("2d").getImageData(1, 250, 1, 1).data];
  });
  assert.deepEqual(shown, [0, 0, 0, 255], "black where they are equal");
}));

test("reports are as small as they should be", () => {
  const size = name => statSync(file_of(name)).size;
  assert.ok(size("right/report.html") < 2e6, `${size("right/report.html")} bytes`);
  assert.ok(size("all_wrong/report.html") < 8e6, `${size("all_wrong/report.html")} bytes`);
  const { report_ms } = JSON.parse(readFileSync(file_of("times.json"), "utf8"));
  console.log(`bytes: ${reports.map(name => `${name} ${size(name)}`).join(", ")}, overview.html ${size("overview.html")}; a report in ${report_ms} ms`);
});

const visible_rows = page => page.locator("tbody tr:not([hidden])").count();
const sums = page => page.locator("tbody tr:not([hidden]) .sum").allInnerTexts();

// Seconds of processor time that a page's main thread was busy: other work on the machine does not count.
const busy_seconds = async session => {
  const { metrics } = await session.send("Performance.getMetrics");
  return metrics.find(metric => metric.name === "TaskDuration").value;
};

test("the batch's page takes a thousand students", async () => {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  const session = await context.newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  await page.goto("file://" + file_of("overview.html"));
  assert.equal(await page.locator("tbody tr").count(), 1000);
  const opened = await busy_seconds(session);
  const texts = ["m", "mü", "mül", "müll", ""];
  for (const text of texts) await page.locator("#search").fill(text);
  const letter = (await busy_seconds(session) - opened) / texts.length;
  console.log(`overview.html opens in ${opened.toFixed(2)} s, a letter takes ${(1000 * letter).toFixed(0)} ms`);
  await context.close();
});

test("the table sorts", () => with_page("overview.html", {}, async page => {
  await page.locator("thead button", { hasText: "Punkte" }).click();
  const down = (await sums(page)).map(text => parseFloat(text || "-1"));
  assert.deepEqual(down, [...down].sort((a, b) => b - a));
  await page.locator("thead button", { hasText: "Punkte" }).press("Enter");
  const up = (await sums(page)).map(text => parseFloat(text || "-1"));
  assert.deepEqual(up, [...up].sort((a, b) => a - b));
  assert.equal(await page.locator("thead th[aria-sort]").getAttribute("aria-sort"), "ascending");
}));

test("the table searches and filters", () => with_page("overview.html", {}, async page => {
  assert.equal(await visible_rows(page), 1000);
  await page.locator("#search").fill("ozturk");
  const found = await page.locator("tbody tr:not([hidden]) th").allInnerTexts();
  assert.ok(found.length > 10 && found.every(name => name.includes("Öztürk")), found.slice(0, 3).join());
  assert.equal(await page.locator("#shown b").innerText(), String(found.length));
  await page.locator("#search").fill("up0007");
  assert.equal(await visible_rows(page), 1);
  await page.getByRole("button", { name: "Alle zeigen" }).click();
  await page.waitForFunction(() => document.querySelectorAll("tbody tr[hidden]").length === 0);
  for (const [field, value] of [["state", "late"], ["state", "ungradable"], ["state", "similar"], ["task", "c"], ["mistake", "repeat_abs"]]) {
    await page.locator(`#${field}`).selectOption(value);
    const count = await visible_rows(page);
    assert.ok(count > 0 && count < 1000, `${field} ${value}: ${count}`);
    await page.locator(`#${field}`).selectOption("");
  }
}));

test("without JavaScript the batch's page has all rows, groups and links", () => with_page("overview.html", { javaScriptEnabled: false }, async page => {
  assert.equal(await page.locator("tbody tr").count(), 1000);
  assert.equal(await page.locator(".filters").isVisible(), false);
  assert.equal(await page.locator("tbody a").first().getAttribute("href"), "reports/student%5F0000/report.html".replace("%5F", "_"));
  await page.locator("#groups ~ details summary").first().click();
  assert.ok(await page.locator(".who a").first().isVisible());
}));
