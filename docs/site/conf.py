"""The site's settings for Sphinx; tools/docs/site.py puts its sources together."""

project = "Illustrate"
author = "The Illustrate authors"
extensions = ["myst_parser"]
html_theme = "furo"
html_title = "Illustrate"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
exclude_patterns = ["_build"]
root_doc = "index"
myst_heading_anchors = 4
myst_links_external_new_tab = False
# Pictures and pages are all on this machine: nothing is fetched.
html_theme_options = {"navigation_with_keys": True}
suppress_warnings = ["myst.header", "epub.unknown_project_files"]
