marks_reduced = Les { $marks } mesures de { $table } proviennent de copies de { NUM($side_px, digits: 5) } px, pas de { NUM($full_px, digits: 5) } px.
