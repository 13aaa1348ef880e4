unusual_errors = Résidus inhabituellement grands : { NUM($rms_px, digits: 2) } px (limite { $limit_rms_px }), partie lisse { NUM($smooth_px, digits: 2) } px (limite { $limit_smooth_px }).
