// Only a place for the headers that all tests read once: see CMakeLists.txt.
