use std::process::ExitCode;

use vitrine::render;

use super::{HOST_FAILED, print};

pub fn doctor() -> anyhow::Result<ExitCode> {
    let adapters = render::adapters();
    let mut text = String::new();
    for (index, adapter) in adapters.iter().enumerate() {
        let yes_no = |yes| if yes { "yes" } else { "no" };
        let size = adapter.max_size;
        text += &format!("{}\n", adapter.description);
        text += &format!("  kind              {}\n", adapter.kind);
        text += &format!("  largest picture   {size}x{size}\n");
        text += &format!("  GPU timing        {}\n", yes_no(adapter.timestamps));
        text += &format!("  64-bit floats     {}\n", yes_no(adapter.float64));
        text += &format!("  sanitizing        {}\n", yes_no(adapter.findings));
        if index == 0 {
            text += "  used unless `--adapter` says otherwise\n";
        }
    }
    if adapters.iter().all(|adapter| adapter.kind == "CPU") {
        text += advice(adapters.is_empty());
        text += "\n";
    }
    print(text.as_bytes())?;
    Ok(match adapters.is_empty() {
        true => HOST_FAILED.into(),
        false => ExitCode::SUCCESS,
    })
}

fn advice(none_at_all: bool) -> &'static str {
    if !none_at_all {
        return "No GPU was found; pictures are drawn on the CPU. With a GPU in this machine, \
                install its maker's Vulkan driver.";
    }
    match std::env::consts::OS {
        "linux" => {
            "No graphics adapter was found. Install your GPU's Vulkan driver, or draw on the CPU:\n  \
             Debian, Ubuntu   apt-get install mesa-vulkan-drivers\n  \
             Fedora           dnf install mesa-vulkan-drivers\n  \
             Arch             pacman -S vulkan-swrast"
        }
        "windows" => {
            "No graphics adapter was found. Install your GPU maker's driver; Windows' own \
             \"Microsoft Basic Render Driver\" draws on the CPU."
        }
        _ => "No graphics adapter was found. Install your GPU maker's driver.",
    }
}
