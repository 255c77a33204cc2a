// A student in a browser: types an answer beside the lesson, sees what is read of it, and what the judge
// says.
#include <doctest/doctest.h>

#include "browser.hpp"

TEST_CASE("an answer is typed beside the lesson: the echo, the verdict, a hint, the standing") {
  if (!has_tool("chromium")) return;
  const Server server;
  Browser browser;
  browser.call("Emulation.setDeviceMetricsOverride",
               {{"width", 360}, {"height", 800}, {"deviceScaleFactor", 1}, {"mobile", false}});
  browser.call("Page.navigate", {{"url", server.url + "lesson-06-reading-a-printed-equation.html"}});
  const std::string box = "document.getElementById('vertical-reaction')", within = box + "?.querySelector";
  browser.wait_for("typeof workbenches !== 'undefined' || " + within + "('input') !== null");
  browser.wait_for("(" + within + "('input').focus(), document.activeElement.name === 'answer')");
  browser.type("g - R*thetadot^2/(2");
  CHECK(browser.wait_for(within + "('output pre')?.textContent") ==
        "this parenthesis is never closed\n  g - R*thetadot^2/(2\n                   ^\n");
  browser.type(")");
  CHECK(browser.wait_for("!" + within + "('output pre') && " + within + "('output mfrac')?.textContent") ==
        "Rθ˙22");
  browser.press_enter();
  CHECK(browser.wait_for(within + "('.said.wrong b')?.textContent") == "Not right yet.");
  CHECK(browser.wait_for(within + "('.standing').textContent") == "(tried, 1 attempt)");
  browser.wait_for("(" + within + "('button[value=hint]').click(), true)");
  CHECK(browser.wait_for(
            within +
            "('.said:not(.wrong) b')?.textContent.startsWith('A hint for your last answer') && 'hint'") ==
        "hint");
  browser.wait_for("(" + within + "('button[value=solution]').click(), true)");
  browser.wait_for("(" + within + "('button[value=give_up]')?.click(), " + within +
                   "('.standing').textContent === '(given up, 1 attempt)')");
  CHECK(browser.wait_for(
            "String(document.documentElement.scrollWidth <= document.documentElement.clientWidth)") ==
        "true");
  CHECK(browser.wait_for("JSON.stringify(performance.getEntriesByType('resource').map((one) => one.name)"
                         ".filter((name) => !/^(data|blob):/.test(name) && !name.startsWith('" +
                         server.url + "')))") == "[]");
  CHECK(
      read_file(server.progress).find("vertical-reaction\tgiven_up\t1\t0\tg - R*thetadot^2/(2)\thinted\n") !=
      std::string::npos);
}

TEST_CASE("a link to an exercise opens it, a choice is made by a radio button, and a dead server is named") {
  if (!has_tool("chromium")) return;
  Server server;
  Browser browser;
  browser.call("Page.navigate", {{"url", server.url + "exercises.html#misprint-in-17"}});
  CHECK(browser.wait_for("[...document.querySelectorAll('.exercise[open]')].map((one) => one.id).join()") ==
        "misprint-in-17");
  const std::string within = "document.getElementById('misprint-in-17').querySelector";
  const Json solution = run_program("exercises", {"--progress", server.folder.path / "other.txt", "solution",
                                                  "--json", "--give-up", "misprint-in-17"})
                            .out;
  const std::string answer = Json::parse(solution.get<std::string>())["answer"];
  browser.wait_for("(" + within + "('[value=\"" + answer + "\"]').click(), true)");
  browser.wait_for("(" + within + "('button[value=check]').click(), true)");
  CHECK(browser.wait_for(within + "('.said.correct b')?.textContent") == "Correct.");
  server.end(SIGTERM);
  browser.wait_for("(" + within + "('button[value=hint]').click(), true)");
  CHECK(browser.wait_for(within + "('.reply').textContent.includes('exercises serve') && 'named'") ==
        "named");
}
