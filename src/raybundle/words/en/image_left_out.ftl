# $image = "img_07.jpg"
image_left_out = Image { $image } is excluded from the adjustment.
