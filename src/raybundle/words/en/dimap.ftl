dimap-no_model = The file contains neither Global_RFM nor Refined_Model.
    .do = Give the file RPC_*.XML or DIM_*.XML of the product.

# $width_px = -2
# $height_px = 4000
dimap-image_size = The domain of validity gives an image of { $width_px } x { $height_px } px.
    .do = Check FIRST_ROW, LAST_ROW, FIRST_COL and LAST_COL.

dimap-no_attitude = The attitude has neither Quaternion_List nor Polynomial_Quaternions.
    .do = Get a complete file, or use the RPC of the product.

dimap-no_bias_prior = The accuracy of the orbit is not stated in DIMAP; the bias has no a-priori standard deviation.

# $refraction = true
# $aberration = false
dimap-corrections = Refraction is { $refraction ->
     [yes] applied
     *[no] not applied
    }, aberration is { $aberration ->
     [yes] applied
     *[no] not applied
    }, as set in the file.
