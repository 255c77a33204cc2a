// Exercises in a page: what is typed goes to the server that sent the page, and its words are shown.
for (const box of document.querySelectorAll(".exercise[data-id]")) {
  const form = box.querySelector("form"), read = box.querySelector("output"), said = box.querySelector(".reply");
  let timer = null, latest = 0;
  const ask = async (what, place) => {
    const write = (kind, text) => place && (place[kind] = text);
    const mine = what === "read" ? ++latest : latest;
    try {
      const reply = await fetch(`exercise/${box.dataset.id}/${what}`, { method: "POST",
        headers: { "Content-Type": "application/json" }, body: JSON.stringify({ answer: form.elements.answer.value }) });
      if (!reply.ok) return write("textContent", await reply.text());
      const { says, standing } = await reply.json();
      if (what === "read" && mine !== latest) return;  // more was typed since
      write("innerHTML", says);
      box.querySelector(".standing").textContent = standing;
    } catch {
      write("textContent", "The server does not answer. Start it again: exercises serve");
    }
  };
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    ask(event.submitter.value, said);
  });
  if (box.open) ask("read", null);  // the standing, which may have changed since the page of the lesson was written
  if (read) form.addEventListener("input", () => {
    clearTimeout(timer);
    timer = setTimeout(() => ask("read", read), 250);
  });
}

/// A link to an exercise opens it.
const opened = () => document.getElementById(location.hash.slice(1))?.closest("details")?.setAttribute("open", "");
addEventListener("hashchange", opened);
opened();
