"""The subcommands of `raybundle calibration`."""
