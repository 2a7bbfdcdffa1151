"use strict";
// Every page works without this; with it more can be seen at once.
document.documentElement.classList.add("js");
for (const choice of document.querySelectorAll("input[name=lang]")) {
  choice.addEventListener("change", () => { document.documentElement.lang = choice.value; });
  if (choice.checked) document.documentElement.lang = choice.value;
}
addEventListener("beforeprint", () => {
  for (const details of document.querySelectorAll("details")) details.open = true;
});
