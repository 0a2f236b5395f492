"""The wire protocol of outlets, written from its text (firmware/wire/README.md) alone: an outlet, a
centre, their links, and proxies that disturb them. No code of the product is used, so that a
difference between product and text shows."""
