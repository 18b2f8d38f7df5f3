use std::process::ExitCode;

use vitrine::render;

use super::HOST_FAILED;

pub fn doctor() -> anyhow::Result<ExitCode> {
    let adapters = render::adapters();
    for (index, adapter) in adapters.iter().enumerate() {
        let yes_no = |yes| if yes { "yes" } else { "no" };
        anstream::println!("{}", adapter.description);
        anstream::println!("  kind              {}", adapter.kind);
        anstream::println!("  largest picture   {0}x{0}", adapter.max_size);
        anstream::println!("  GPU timing        {}", yes_no(adapter.timestamps));
        anstream::println!("  64-bit floats     {}", yes_no(adapter.float64));
        if index == 0 {
            anstream::println!("  used unless `--adapter` says otherwise");
        }
    }
    if adapters.iter().all(|adapter| adapter.kind == "CPU") {
        anstream::println!("{}", advice(adapters.is_empty()));
    }
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
