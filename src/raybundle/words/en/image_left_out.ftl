# $image = "img_07.jpg"
image_left_out = Image { $image } is excluded from the adjustment.
    .why = The result contains no orientation of this image; the object points rest on the other images.
    .do = Remove the cause below and adjust again, or use the result without this image.
