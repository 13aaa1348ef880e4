video-frames = Einzelbilder: { $n } von { $of } gewählt ({ NUM($seconds, decimals: 1) } s, { $width_px } x { $height_px } px).

video-no_motion = Der Blick bewegt sich kaum: Einzelbilder ohne Basis ergeben keine Objektkoordinaten.

video-same_frames = { $n } { $n ->
        [one] Einzelbild zeigt dasselbe wie das vorige und entfällt.
        *[other] Einzelbilder zeigen dasselbe wie das vorige und entfallen.
    }

video-blurred = { $n } gewählte { $n ->
        [one] Einzelbild ist
        *[other] Einzelbilder sind
    } weniger als { PERCENT($share) } % so scharf wie das typische: { $frames }.

video-fewer_frames = { $n } Einzelbilder statt { $wanted }: Die übrigen liegen zu dicht beieinander.
