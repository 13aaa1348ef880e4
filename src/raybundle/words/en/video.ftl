video-count_and_time = The number of frames and the time between them exclude each other.
    .do = Give one of them.

# $option = "count"
# $value = 0.0
video-option_not_positive = { $option ->
        [count] The number of frames
        [every_s] The time between frames [s]
       *[motion] The motion between frames
     } is { $value }.
    .do = Give a value above 0.

video-not_decoded = The video cannot be decoded.
    .do = Convert it to MP4 (H.264).

video-no_frame = The video has no frame that can be decoded.
    .do = Check that the file is complete.
