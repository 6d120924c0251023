// Builds the report into one HTML file: script and style are put into the page itself.
import { defineConfig, type Plugin } from "vite";

const marker = "@FIBERFATE_DOCUMENT@";

// Without this a literal closing tag inside the bundle would end the inline element early.
function escape_closing_tag(text: string, tag: string): string {
  return text.replaceAll(new RegExp(`</(${tag})`, "gi"), "<\\/$1");
}

function inline_everything(): Plugin {
  return {
    name: "inline-everything",
    enforce: "post",
    generateBundle(_options, bundle) {
      const page = bundle["index.html"];
      if (page?.type !== "asset") throw new Error("the build made no index.html");
      let html = String(page.source);
      html = html.replace(/<script type="module"[^>]*><\/script>/, "");
      html = html.replace(/<link rel="(stylesheet|modulepreload)"[^>]*>/g, "");
      for (const [name, file] of Object.entries(bundle)) {
        if (file.type === "chunk") {
          const script = `<script type="module">${escape_closing_tag(file.code, "script")}</script>`;
          html = html.replace("</body>", () => `${script}\n</body>`);
        } else if (name.endsWith(".css")) {
          const style = `<style>${escape_closing_tag(String(file.source), "style")}</style>`;
          html = html.replace("</head>", () => `${style}\n</head>`);
        } else continue;
        delete bundle[name];
      }
      if (html.split(marker).length !== 2) throw new Error(`index.html must hold ${marker} exactly once`);
      page.source = html;
    },
  };
}

export default defineConfig({
  base: "./",
  build: {
    target: "es2020",
    modulePreload: false,
    cssCodeSplit: false,
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    chunkSizeWarningLimit: 2000,
    rollupOptions: { output: { inlineDynamicImports: true } },
  },
  plugins: [inline_everything()],
});
