// A target has a source; what this one is for are the headers that are compiled with it.
