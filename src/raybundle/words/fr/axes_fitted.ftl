axes_fitted = Les axes de { $name } concordent en { $n } points à { NUM($rms_mm, digits: 2) } mm près (rms).
