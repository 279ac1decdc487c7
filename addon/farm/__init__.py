"""Many frames without a window, on one machine or many: drawn one by one, then merged."""
