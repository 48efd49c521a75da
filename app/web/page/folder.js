// Browsers run no program from a folder that no server serves: say so in place of a page that loads for ever.
if (location.protocol === "file:") {
  document.getElementById("loading").firstElementChild.textContent =
    "Jointwise runs from a web server, any will do; browsers run no program from a folder. The pages of a course can be read from there.";
  document.getElementById("progress").hidden = true;
}
