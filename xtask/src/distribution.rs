//! The packages with a Vulkan driver, by Linux distribution.

use std::fs;

/// A Linux distribution, by its package manager.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Distribution {
    /// Debian, Ubuntu and their kin.
    Debian,
    /// Fedora, Red Hat and their kin.
    Fedora,
    /// Arch and its kin.
    Arch,
    /// SUSE and openSUSE.
    Suse,
    /// Alpine.
    Alpine,
    /// Any other.
    Other,
}

impl Distribution {
    /// The distribution that this machine runs.
    pub fn of_this_machine() -> Self {
        Self::from_os_release(&fs::read_to_string("/etc/os-release").unwrap_or_default())
    }

    /// Reads `ID` and `ID_LIKE` of an os-release file.
    fn from_os_release(text: &str) -> Self {
        let value = |key: &str| {
            let line = text.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix('='));
            line.unwrap_or_default().trim_matches('"').to_owned()
        };
        let names = format!("{} {}", value("ID"), value("ID_LIKE"));
        names.split_whitespace().find_map(Self::from_name).unwrap_or(Self::Other)
    }

    fn from_name(name: &str) -> Option<Self> {
        match name {
            "debian" | "ubuntu" => Some(Self::Debian),
            "fedora" | "rhel" | "centos" => Some(Self::Fedora),
            "arch" => Some(Self::Arch),
            "suse" | "opensuse" => Some(Self::Suse),
            "alpine" => Some(Self::Alpine),
            _ => None,
        }
    }

    /// The command that installs Mesa's software driver and the Vulkan loader.
    pub fn installation(self) -> Option<&'static [&'static str]> {
        match self {
            Self::Debian => {
                Some(&["apt-get", "install", "--yes", "--no-install-recommends", "mesa-vulkan-drivers", "libvulkan1"])
            }
            Self::Fedora => Some(&["dnf", "install", "mesa-vulkan-drivers", "vulkan-loader"]),
            Self::Arch => Some(&["pacman", "-S", "vulkan-swrast", "vulkan-icd-loader"]),
            Self::Suse => Some(&["zypper", "install", "libvulkan_lvp", "libvulkan1"]),
            Self::Alpine => Some(&["apk", "add", "mesa-vulkan-swrast", "vulkan-loader"]),
            Self::Other => None,
        }
    }

    /// Advice for a machine that has no Vulkan driver.
    pub fn advice(self) -> String {
        match self.installation() {
            Some(command) => format!("run as root: {}", command.join(" ")),
            None => "install Mesa's lavapipe driver and the Vulkan loader (libvulkan.so.1)".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distribution_is_known_by_itself_or_by_its_kin() {
        let of = Distribution::from_os_release;
        assert_eq!(of("PRETTY_NAME=\"Debian GNU/Linux 12\"\nID=debian\n"), Distribution::Debian);
        assert_eq!(of("ID=linuxmint\nID_LIKE=\"ubuntu debian\"\n"), Distribution::Debian);
        assert_eq!(of("ID=\"rocky\"\nID_LIKE=\"rhel centos fedora\"\n"), Distribution::Fedora);
        assert_eq!(of("ID=\"opensuse-leap\"\nID_LIKE=\"suse opensuse\"\n"), Distribution::Suse);
        assert_eq!(of("ID=endeavouros\nID_LIKE=arch\n"), Distribution::Arch);
        assert_eq!(of("ID=alpine\n"), Distribution::Alpine);
    }

    #[test]
    fn an_unknown_distribution_gets_general_advice() {
        assert_eq!(Distribution::from_os_release("ID=nixos\n"), Distribution::Other);
        assert_eq!(Distribution::from_os_release(""), Distribution::Other);
    }
}
