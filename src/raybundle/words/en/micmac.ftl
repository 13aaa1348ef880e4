micmac-affine_frame = An affine frame of the sensor (OrIntGlob) is not supported.
    .do = Calibrate without it.

micmac-several_distortions = Several distortions in sequence are not supported.
    .do = Calibrate with one distortion.

# $n = 0
micmac-model_count = Models of distortion: { $n }; exactly one is needed.
    .do = Check that the file is complete.

# $n = 7
# $most = 5
micmac-radial_count = The radial distortion has { $n } coefficients; at most { $most } are supported.
    .do = Calibrate with fewer.
