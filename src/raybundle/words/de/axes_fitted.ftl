axes_fitted = Die Achsen von { $name } passen an { $n } Punkten auf { NUM($rms_mm, digits: 2) } mm (rms).
    .why = Die Drehung der Achsen ist auf { NUM($rotation_mrad, digits: 2) } mrad bekannt ({ NUM($largest_mm, digits: 2) } mm bei der größten Verschiebung) und in den Standardabweichungen enthalten.
