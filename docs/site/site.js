// SPDX-License-Identifier: MIT
// Makes the figures live: where one comes near, figures.js puts its frame behind the picture and draws it with the engine that
// all figures of a page share. The picture stays until the fractal is seen.

/** @param {HTMLElement} figure */
function enliven(figure) {
  const still = figure.querySelector("img");
  const script = document.createElement("script"), place = document.createElement("div");
  Object.assign(script.dataset, figure.dataset, { title: still?.alt });
  script.src = new URL("figures.js", siteRoot).href;
  script.addEventListener("load", () => {
    const frame = figure.querySelector("iframe");
    frame?.addEventListener("load", () => {
      const body = frame.contentDocument?.body;
      if (!body) return;
      body.querySelector("footer")?.remove(); // which says what it is made with
      const look = () => {
        if (body.dataset.state !== "live") return;
        // Once the frame is as high as it stays: what is read below moves once, and browsers keep it in place.
        requestAnimationFrame(() => requestAnimationFrame(() => figure.classList.add("live")));
      };
      new MutationObserver(look).observe(body, { attributeFilter: ["data-state"] });
      look();
    });
  });
  figure.classList.add("soon");
  place.append(script);
  figure.append(place);
}

/** What is wider than its place can be scrolled by keys. */
function reachWideParts() {
  for (const part of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("pre, .scroll"))) {
    if (part.scrollWidth > part.clientWidth) part.tabIndex = 0;
    else part.removeAttribute("tabindex");
  }
}

/** Marks the section that is read in the list of sections. */
function followReader() {
  const links = /** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll(".contents a"));
  const heads = [...links].map((link) => document.getElementById(decodeURIComponent(link.hash.slice(1))));
  const mark = () => {
    const read = heads.filter((head) => head && head.getBoundingClientRect().top < innerHeight / 4).length - 1;
    links.forEach((link, i) => link.classList.toggle("read", i === read));
    links[read]?.scrollIntoView({ block: "nearest" });
  };
  addEventListener("scroll", () => requestAnimationFrame(mark), { passive: true });
  mark();
}

const siteRoot = /** @type {HTMLScriptElement} */ (document.currentScript).src;
const near = new IntersectionObserver((seen) => {
  for (const { isIntersecting, target } of seen) {
    if (!isIntersecting) continue;
    near.unobserve(target);
    enliven(/** @type {HTMLElement} */ (target));
  }
}, { rootMargin: "400px" });
document.querySelectorAll("figure[data-entry]").forEach((figure) => near.observe(figure));
document.querySelector("header nav")?.addEventListener("click", () => document.querySelector("details")?.removeAttribute("open"));
addEventListener("resize", reachWideParts);
reachWideParts();
followReader();
