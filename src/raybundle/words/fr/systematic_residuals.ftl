systematic_residuals = Les résidus moyens sur le format diffèrent de zéro (caméras { $ids }).

systematic_residuals-camera = Caméra { $camera } : { $cells } cellules sur { $tested }, { NUM($rms_px, digits: 2) } px rms ({ PERCENT($share) } % des résidus), au plus { NUM($largest_px, digits: 2) } px.
