//! The system's sound device.

use std::sync::{Arc, Mutex};

use cpal::traits::{DeviceTrait as _, HostTrait as _, StreamTrait as _};
use cpal::{FromSample, SampleFormat, SizedSample};

use super::tape::Tape;
use crate::report;

/// Opens the system's usual output, which plays what is on the tape from now on, as long as the stream lives.
pub(super) fn open(tape: &Arc<Mutex<Tape>>) -> Result<cpal::Stream, String> {
    let device = cpal::default_host().default_output_device();
    let device = device.ok_or("the system has no sound device")?;
    let config = device.default_output_config().map_err(words)?;
    let stream = match config.sample_format() {
        SampleFormat::F32 => stream::<f32>(&device, config.into(), tape),
        SampleFormat::F64 => stream::<f64>(&device, config.into(), tape),
        SampleFormat::I8 => stream::<i8>(&device, config.into(), tape),
        SampleFormat::I16 => stream::<i16>(&device, config.into(), tape),
        SampleFormat::I32 => stream::<i32>(&device, config.into(), tape),
        SampleFormat::U8 => stream::<u8>(&device, config.into(), tape),
        SampleFormat::U16 => stream::<u16>(&device, config.into(), tape),
        SampleFormat::U32 => stream::<u32>(&device, config.into(), tape),
        other => {
            return Err(format!(
                "the sound device wants samples of the kind {other}"
            ));
        }
    }?;
    stream.play().map_err(words)?;
    Ok(stream)
}

fn words(error: cpal::Error) -> String {
    error.to_string()
}

fn stream<T: SizedSample + FromSample<f32>>(
    device: &cpal::Device,
    config: cpal::StreamConfig,
    tape: &Arc<Mutex<Tape>>,
) -> Result<cpal::Stream, String> {
    let (channels, rate) = (usize::from(config.channels), f64::from(config.sample_rate));
    let tape = Arc::clone(tape);
    let mut samples = Vec::new();
    let fill = move |out: &mut [T], _: &cpal::OutputCallbackInfo| {
        samples.resize(out.len(), 0.0);
        tape.lock()
            .expect("no holder panics")
            .fill(&mut samples, channels, rate);
        for (out, sample) in out.iter_mut().zip(&samples) {
            *out = T::from_sample(*sample);
        }
    };
    let mut has_complained = false;
    let complain = move |error: cpal::Error| {
        // A late buffer is a crackle, and no news.
        if !has_complained && error.kind() != cpal::ErrorKind::Xrun {
            has_complained = true;
            report::tell(format_args!("the sound device: {error}"));
        }
    };
    device
        .build_output_stream(config, fill, complain, None)
        .map_err(words)
}
