struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_19 {
member: array<u32>,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_22 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_23 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_24 {
member: type_5,
member_1: type_5,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_20,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_21,
member_8: type_22,
member_9: type_22,
member_10: type_23,
member_11: type_24,
member_12: type_14,
member_13: type_21,
member_14: type_4,
member_15: type_9,
member_16: type_25,
member_17: type_25,
member_18: type_25,
member_19: type_25,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_27 {
member: type_26,
}
struct type_31 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_27;
@group(0) @binding(3)
var<storage> global_2: type_19;
@group(0) @binding(1)
var<storage> global_3: type_16;
@group(0) @binding(2)
var<storage> global_4: type_16;
@group(0) @binding(4)
var<storage, read_write> global_5: type_31;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_6298_: i32;
var phi_6395_: i32;
var phi_6439_: i32;
var phi_6474_: u32;
var phi_6516_: u32;
var phi_6556_: u32;
var phi_6299_: i32;
var phi_3613_: i32;
var phi_3628_: f32;
var phi_3634_: f32;
var phi_3853_: i32;
var phi_3897_: i32;
var phi_3809_: i32;
var phi_3898_: i32;
var phi_3932_: u32;
var phi_3974_: u32;
var phi_4014_: u32;
var phi_3614_: i32;
var phi_2978_: vec2<f32>;
var phi_2979_: vec2<f32>;
var phi_2989_: vec2<f32>;
var phi_3020_: i32;
var phi_3103_: i32;
var phi_3118_: f32;
var phi_3124_: f32;
var phi_3343_: i32;
var phi_3387_: i32;
var phi_3299_: i32;
var phi_3388_: i32;
var phi_3422_: u32;
var phi_3464_: u32;
var phi_3504_: u32;
var phi_3104_: i32;
var phi_3021_: i32;
var phi_2530_: i32;
var phi_2678_: i32;
var phi_2765_: i32;
var phi_2809_: i32;
var phi_2721_: i32;
var phi_2810_: i32;
var phi_2844_: u32;
var phi_2886_: u32;
var phi_2926_: u32;
var phi_2679_: i32;
var phi_2531_: i32;
var phi_5560_: i32;
var phi_5575_: f32;
var phi_5581_: f32;
var phi_5800_: i32;
var phi_5844_: i32;
var phi_5756_: i32;
var phi_5845_: i32;
var phi_5879_: u32;
var phi_5921_: u32;
var phi_5961_: u32;
var phi_5561_: i32;
var phi_4925_: vec2<f32>;
var phi_4926_: vec2<f32>;
var phi_4936_: vec2<f32>;
var phi_4967_: i32;
var phi_5050_: i32;
var phi_5065_: f32;
var phi_5071_: f32;
var phi_5290_: i32;
var phi_5334_: i32;
var phi_5246_: i32;
var phi_5335_: i32;
var phi_5369_: u32;
var phi_5411_: u32;
var phi_5451_: u32;
var phi_5051_: i32;
var phi_4968_: i32;
var phi_4477_: i32;
var phi_4625_: i32;
var phi_4712_: i32;
var phi_4756_: i32;
var phi_4668_: i32;
var phi_4757_: i32;
var phi_4791_: u32;
var phi_4833_: u32;
var phi_4873_: u32;
var phi_4626_: i32;
var phi_4478_: i32;
var phi_1670_: i32;
var phi_1818_: i32;
var phi_1905_: i32;
var phi_1949_: i32;
var phi_1861_: i32;
var phi_1950_: i32;
var phi_1984_: u32;
var phi_2026_: u32;
var phi_2066_: u32;
var phi_1819_: i32;
var phi_1671_: i32;
let _e53 = global;
let _e61 = arrayLength((&global_2.member));
let _e64 = arrayLength((&global_5.member));
let _e67 = global_1.member.member_2;
let _e73 = (_e53.x + _e67.member);
let _e75 = (_e53.y + _e67.member_1);
if (_e73 < _e67.member_2) {
if (_e75 < _e67.member_3) {
let _e80 = global_1.member.member;
let _e86 = global_1.member.member_12.member_4.member;
let _e91 = global_1.member.member_12.member_4.member_1;
let _e93 = bitcast<i32>((_e86 * _e91));
let _e96 = bitcast<i32>(((_e75 * _e86) + _e73));
let _e98 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e100 = select(_e98, _e96, (_e96 < _e98));
let _e106 = global_3.member[bitcast<u32>(select(0i, _e100, (_e100 > 0i)))];
if (_e106 == 16f) {
let _e479 = (_e86 + 1u);
let _e482 = bitcast<i32>((_e479 * (_e91 + 1u)));
local_6 = _e482;
let _e483 = (_e75 * _e479);
local_7 = bitcast<i32>((_e483 + _e73));
let _e486 = local_7;
let _e488 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e490 = select(_e488, _e486, (_e486 < _e488));
let _e495 = global_4.member[bitcast<u32>(select(0i, _e490, (_e490 > 0i)))];
let _e496 = local_6;
let _e497 = local_7;
let _e498 = (_e496 + _e497);
let _e500 = select(_e488, _e498, (_e498 < _e488));
let _e505 = global_4.member[bitcast<u32>(select(0i, _e500, (_e500 > 0i)))];
let _e506 = local_6;
let _e508 = local_7;
let _e509 = ((2i * _e506) + _e508);
let _e511 = select(_e488, _e509, (_e509 < _e488));
let _e516 = global_4.member[bitcast<u32>(select(0i, _e511, (_e511 > 0i)))];
let _e517 = local_6;
let _e519 = local_7;
let _e520 = ((3i * _e517) + _e519);
let _e522 = select(_e488, _e520, (_e520 < _e488));
let _e527 = global_4.member[bitcast<u32>(select(0i, _e522, (_e522 > 0i)))];
let _e528 = local_6;
let _e530 = local_7;
let _e531 = ((4i * _e528) + _e530);
let _e533 = select(_e488, _e531, (_e531 < _e488));
let _e538 = global_4.member[bitcast<u32>(select(0i, _e533, (_e533 > 0i)))];
let _e539 = local_6;
let _e541 = local_7;
let _e542 = ((5i * _e539) + _e541);
let _e544 = select(_e488, _e542, (_e542 < _e488));
let _e549 = global_4.member[bitcast<u32>(select(0i, _e544, (_e544 > 0i)))];
let _e550 = local_6;
let _e552 = local_7;
let _e553 = ((6i * _e550) + _e552);
let _e555 = select(_e488, _e553, (_e553 < _e488));
let _e560 = global_4.member[bitcast<u32>(select(0i, _e555, (_e555 > 0i)))];
let _e561 = local_6;
let _e563 = local_7;
let _e564 = ((7i * _e561) + _e563);
let _e566 = select(_e488, _e564, (_e564 < _e488));
let _e571 = global_4.member[bitcast<u32>(select(0i, _e566, (_e566 > 0i)))];
let _e572 = (_e73 + 1u);
local_4 = _e482;
local_5 = bitcast<i32>((_e483 + _e572));
let _e575 = local_5;
let _e577 = select(_e488, _e575, (_e575 < _e488));
let _e582 = global_4.member[bitcast<u32>(select(0i, _e577, (_e577 > 0i)))];
let _e583 = local_4;
let _e584 = local_5;
let _e585 = (_e583 + _e584);
let _e587 = select(_e488, _e585, (_e585 < _e488));
let _e592 = global_4.member[bitcast<u32>(select(0i, _e587, (_e587 > 0i)))];
let _e593 = local_4;
let _e595 = local_5;
let _e596 = ((2i * _e593) + _e595);
let _e598 = select(_e488, _e596, (_e596 < _e488));
let _e603 = global_4.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e604 = local_4;
let _e606 = local_5;
let _e607 = ((3i * _e604) + _e606);
let _e609 = select(_e488, _e607, (_e607 < _e488));
let _e614 = global_4.member[bitcast<u32>(select(0i, _e609, (_e609 > 0i)))];
let _e615 = local_4;
let _e617 = local_5;
let _e618 = ((4i * _e615) + _e617);
let _e620 = select(_e488, _e618, (_e618 < _e488));
let _e625 = global_4.member[bitcast<u32>(select(0i, _e620, (_e620 > 0i)))];
let _e626 = local_4;
let _e628 = local_5;
let _e629 = ((5i * _e626) + _e628);
let _e631 = select(_e488, _e629, (_e629 < _e488));
let _e636 = global_4.member[bitcast<u32>(select(0i, _e631, (_e631 > 0i)))];
let _e637 = local_4;
let _e639 = local_5;
let _e640 = ((6i * _e637) + _e639);
let _e642 = select(_e488, _e640, (_e640 < _e488));
let _e647 = global_4.member[bitcast<u32>(select(0i, _e642, (_e642 > 0i)))];
let _e648 = local_4;
let _e650 = local_5;
let _e651 = ((7i * _e648) + _e650);
let _e653 = select(_e488, _e651, (_e651 < _e488));
let _e658 = global_4.member[bitcast<u32>(select(0i, _e653, (_e653 > 0i)))];
local_2 = _e482;
let _e660 = ((_e75 + 1u) * _e479);
local_3 = bitcast<i32>((_e660 + _e73));
let _e663 = local_3;
let _e665 = select(_e488, _e663, (_e663 < _e488));
let _e670 = global_4.member[bitcast<u32>(select(0i, _e665, (_e665 > 0i)))];
let _e671 = local_2;
let _e672 = local_3;
let _e673 = (_e671 + _e672);
let _e675 = select(_e488, _e673, (_e673 < _e488));
let _e680 = global_4.member[bitcast<u32>(select(0i, _e675, (_e675 > 0i)))];
let _e681 = local_2;
let _e683 = local_3;
let _e684 = ((2i * _e681) + _e683);
let _e686 = select(_e488, _e684, (_e684 < _e488));
let _e691 = global_4.member[bitcast<u32>(select(0i, _e686, (_e686 > 0i)))];
let _e692 = local_2;
let _e694 = local_3;
let _e695 = ((3i * _e692) + _e694);
let _e697 = select(_e488, _e695, (_e695 < _e488));
let _e702 = global_4.member[bitcast<u32>(select(0i, _e697, (_e697 > 0i)))];
let _e703 = local_2;
let _e705 = local_3;
let _e706 = ((4i * _e703) + _e705);
let _e708 = select(_e488, _e706, (_e706 < _e488));
let _e713 = global_4.member[bitcast<u32>(select(0i, _e708, (_e708 > 0i)))];
let _e714 = local_2;
let _e716 = local_3;
let _e717 = ((5i * _e714) + _e716);
let _e719 = select(_e488, _e717, (_e717 < _e488));
let _e724 = global_4.member[bitcast<u32>(select(0i, _e719, (_e719 > 0i)))];
let _e725 = local_2;
let _e727 = local_3;
let _e728 = ((6i * _e725) + _e727);
let _e730 = select(_e488, _e728, (_e728 < _e488));
let _e735 = global_4.member[bitcast<u32>(select(0i, _e730, (_e730 > 0i)))];
let _e736 = local_2;
let _e738 = local_3;
let _e739 = ((7i * _e736) + _e738);
let _e741 = select(_e488, _e739, (_e739 < _e488));
let _e746 = global_4.member[bitcast<u32>(select(0i, _e741, (_e741 > 0i)))];
local = _e482;
local_1 = bitcast<i32>((_e660 + _e572));
let _e749 = local_1;
let _e751 = select(_e488, _e749, (_e749 < _e488));
let _e756 = global_4.member[bitcast<u32>(select(0i, _e751, (_e751 > 0i)))];
let _e757 = local;
let _e758 = local_1;
let _e759 = (_e757 + _e758);
let _e761 = select(_e488, _e759, (_e759 < _e488));
let _e766 = global_4.member[bitcast<u32>(select(0i, _e761, (_e761 > 0i)))];
let _e767 = local;
let _e769 = local_1;
let _e770 = ((2i * _e767) + _e769);
let _e772 = select(_e488, _e770, (_e770 < _e488));
let _e777 = global_4.member[bitcast<u32>(select(0i, _e772, (_e772 > 0i)))];
let _e778 = local;
let _e780 = local_1;
let _e781 = ((3i * _e778) + _e780);
let _e783 = select(_e488, _e781, (_e781 < _e488));
let _e788 = global_4.member[bitcast<u32>(select(0i, _e783, (_e783 > 0i)))];
let _e789 = local;
let _e791 = local_1;
let _e792 = ((4i * _e789) + _e791);
let _e794 = select(_e488, _e792, (_e792 < _e488));
let _e799 = global_4.member[bitcast<u32>(select(0i, _e794, (_e794 > 0i)))];
let _e800 = local;
let _e802 = local_1;
let _e803 = ((5i * _e800) + _e802);
let _e805 = select(_e488, _e803, (_e803 < _e488));
let _e810 = global_4.member[bitcast<u32>(select(0i, _e805, (_e805 > 0i)))];
let _e811 = local;
let _e813 = local_1;
let _e814 = ((6i * _e811) + _e813);
let _e816 = select(_e488, _e814, (_e814 < _e488));
let _e821 = global_4.member[bitcast<u32>(select(0i, _e816, (_e816 > 0i)))];
let _e822 = local;
let _e824 = local_1;
let _e825 = ((7i * _e822) + _e824);
let _e827 = select(_e488, _e825, (_e825 < _e488));
let _e832 = global_4.member[bitcast<u32>(select(0i, _e827, (_e827 > 0i)))];
let _e834 = select(_e582, _e495, (_e495 < _e582));
let _e836 = select(_e756, _e670, (_e670 < _e756));
let _e840 = select(_e592, _e505, (_e505 < _e592));
let _e842 = select(_e766, _e680, (_e680 < _e766));
let _e846 = select(_e582, _e495, (_e495 > _e582));
let _e848 = select(_e756, _e670, (_e670 > _e756));
let _e852 = select(_e592, _e505, (_e505 > _e592));
let _e854 = select(_e766, _e680, (_e680 > _e766));
let _e857 = (select(_e848, _e846, (_e846 > _e848)) - select(_e836, _e834, (_e834 < _e836)));
let _e858 = (select(_e854, _e852, (_e852 > _e854)) - select(_e842, _e840, (_e840 < _e842)));
let _e860 = select(_e858, _e857, (_e857 > _e858));
let _e877 = ((_e860 > 16f) || ((_e860 > 6f) && ((0.5f * bitcast<f32>((bitcast<u32>((((_e756 - _e495) * (_e680 - _e592)) - ((_e766 - _e505) * (_e670 - _e582)))) & 2147483647u))) > (2f * _e860))));
let _e878 = select(1f, 4f, _e877);
let _e879 = (1f / _e878);
let _e880 = (_e495 * _e879);
let _e881 = (_e505 * _e879);
let _e882 = (_e582 * _e879);
let _e883 = (_e592 * _e879);
let _e884 = (_e670 * _e879);
let _e885 = (_e680 * _e879);
let _e886 = (_e756 * _e879);
let _e887 = (_e766 * _e879);
let _e888 = (_e880 - _e884);
let _e891 = (_e881 - _e885);
let _e894 = ((_e888 * (_e883 - _e885)) - (_e891 * (_e882 - _e884)));
let _e895 = (_e882 - _e880);
let _e896 = (_e887 - _e881);
let _e898 = (_e883 - _e881);
let _e899 = (_e886 - _e880);
let _e901 = ((_e895 * _e896) - (_e898 * _e899));
let _e902 = (_e886 - _e882);
let _e903 = (_e885 - _e883);
let _e905 = (_e887 - _e883);
let _e906 = (_e884 - _e882);
let _e908 = ((_e902 * _e903) - (_e905 * _e906));
let _e909 = (_e884 - _e886);
let _e912 = (_e885 - _e887);
let _e915 = ((_e909 * (_e881 - _e887)) - (_e912 * (_e880 - _e886)));
let _e931 = (_e571 == 2f);
let _e932 = (_e658 == 2f);
let _e934 = (_e746 == 2f);
let _e936 = (_e832 == 2f);
let _e946 = (0.5f * bitcast<f32>((bitcast<u32>(((_e899 * _e903) - (_e896 * _e906))) & 2147483647u)));
if ((((((((_e894 > 0f) && (_e901 > 0f)) && (_e915 > 0f)) && (_e908 > 0f)) || ((((_e894 < 0f) && (_e901 < 0f)) && (_e915 < 0f)) && (_e908 < 0f))) && !((((_e931 || _e932) || _e934) || _e936))) && (_e946 >= 0.5f)) && (_e860 <= 64f)) {
let _e3444 = (1f / 3f);
let _e3445 = (((_e516 + _e527) + _e538) * _e3444);
let _e3450 = (((_e603 + _e614) + _e625) * _e3444);
let _e3457 = (((_e691 + _e702) + _e713) * _e3444);
let _e3462 = (((_e777 + _e788) + _e799) * _e3444);
let _e3477 = global_1.member.member_12.member_22;
let _e3478 = (_e3477 * ((1f / _e946) / (_e878 * _e878)));
let _e3480 = (((((_e516 + _e603) + (_e691 + _e777)) * 0.25f) * _e3478) + 0.5f);
let _e3482 = select(-1073741800f, _e3480, (_e3480 > -1073741800f));
let _e3484 = select(1073741800f, _e3482, (_e3482 < 1073741800f));
let _e3491 = select(0i, select(select(i32(_e3484), i32(-2147483648), (_e3484 < -2147483600f)), 2147483647i, (_e3484 > 2147483500f)), (_e3484 == _e3484));
let _e3495 = (_e3491 - select(0i, 1i, (_e3484 < f32(_e3491))));
let _e3497 = (((((_e527 + _e614) + (_e702 + _e788)) * 0.25f) * _e3478) + 0.5f);
let _e3499 = select(-1073741800f, _e3497, (_e3497 > -1073741800f));
let _e3501 = select(1073741800f, _e3499, (_e3499 < 1073741800f));
let _e3508 = select(0i, select(select(i32(_e3501), i32(-2147483648), (_e3501 < -2147483600f)), 2147483647i, (_e3501 > 2147483500f)), (_e3501 == _e3501));
let _e3514 = (((((_e538 + _e625) + (_e713 + _e799)) * 0.25f) * _e3478) + 0.5f);
let _e3516 = select(-1073741800f, _e3514, (_e3514 > -1073741800f));
let _e3518 = select(1073741800f, _e3516, (_e3516 < 1073741800f));
let _e3525 = select(0i, select(select(i32(_e3518), i32(-2147483648), (_e3518 < -2147483600f)), 2147483647i, (_e3518 > 2147483500f)), (_e3518 == _e3518));
let _e3529 = (_e3525 - select(0i, 1i, (_e3518 < f32(_e3525))));
let _e3531 = ((((((_e549 * _e3445) + (_e636 * _e3450)) + ((_e724 * _e3457) + (_e810 * _e3462))) * 0.25f) * _e3478) + 0.5f);
let _e3533 = select(-1073741800f, _e3531, (_e3531 > -1073741800f));
let _e3535 = select(1073741800f, _e3533, (_e3533 < 1073741800f));
let _e3542 = select(0i, select(select(i32(_e3535), i32(-2147483648), (_e3535 < -2147483600f)), 2147483647i, (_e3535 > 2147483500f)), (_e3535 == _e3535));
let _e3546 = (_e3542 - select(0i, 1i, (_e3535 < f32(_e3542))));
let _e3548 = ((((((_e560 * _e3445) + (_e647 * _e3450)) + ((_e735 * _e3457) + (_e821 * _e3462))) * 0.25f) * _e3478) + 0.5f);
let _e3550 = select(-1073741800f, _e3548, (_e3548 > -1073741800f));
let _e3552 = select(1073741800f, _e3550, (_e3550 < 1073741800f));
let _e3559 = select(0i, select(select(i32(_e3552), i32(-2147483648), (_e3552 < -2147483600f)), 2147483647i, (_e3552 > 2147483500f)), (_e3552 == _e3552));
let _e3565 = select(_e883, _e881, (_e881 < _e883));
let _e3567 = select(_e885, _e887, (_e887 < _e885));
let _e3569 = select(_e3567, _e3565, (_e3565 < _e3567));
let _e3571 = select(_e883, _e881, (_e881 > _e883));
let _e3573 = select(_e885, _e887, (_e887 > _e885));
let _e3575 = select(_e3573, _e3571, (_e3571 > _e3573));
let _e3576 = -(65536f);
let _e3578 = select(_e3576, _e3569, (_e3569 > _e3576));
let _e3580 = select(65536f, _e3578, (_e3578 < 65536f));
let _e3587 = select(0i, select(select(i32(_e3580), i32(-2147483648), (_e3580 < -2147483600f)), 2147483647i, (_e3580 > 2147483500f)), (_e3580 == _e3580));
let _e3594 = select(_e3576, _e3575, (_e3575 > _e3576));
let _e3596 = select(65536f, _e3594, (_e3594 < 65536f));
let _e3603 = select(0i, select(select(i32(_e3596), i32(-2147483648), (_e3596 < -2147483600f)), 2147483647i, (_e3596 > 2147483500f)), (_e3596 == _e3596));
phi_1670_ = ((_e3587 - select(0i, 1i, (_e3580 < f32(_e3587)))) + 1i);
loop {
let _e3609 = phi_1670_;
let _e3610 = (_e3609 <= (_e3603 - select(0i, 1i, (_e3596 < f32(_e3603)))));
if _e3610 {
let _e3611 = f32(_e3609);
let _e3615 = (_e880 + ((_e3611 - _e881) * (_e895 / _e898)));
let _e3616 = (_e881 <= _e3611);
let _e3617 = (_e883 <= _e3611);
let _e3618 = (_e3616 != _e3617);
let _e3621 = select(65536f, select(_e3615, 65536f, (65536f < _e3615)), _e3618);
let _e3624 = select(_e3576, select(_e3615, _e3576, (_e3576 > _e3615)), _e3618);
let _e3628 = (_e882 + ((_e3611 - _e883) * (_e902 / _e905)));
let _e3629 = (_e887 <= _e3611);
let _e3630 = (_e3617 != _e3629);
let _e3633 = select(_e3621, select(_e3628, _e3621, (_e3621 < _e3628)), _e3630);
let _e3636 = select(_e3624, select(_e3628, _e3624, (_e3624 > _e3628)), _e3630);
let _e3640 = (_e886 + ((_e3611 - _e887) * (_e909 / _e912)));
let _e3641 = (_e885 <= _e3611);
let _e3642 = (_e3629 != _e3641);
let _e3645 = select(_e3633, select(_e3640, _e3633, (_e3633 < _e3640)), _e3642);
let _e3648 = select(_e3636, select(_e3640, _e3636, (_e3636 > _e3640)), _e3642);
let _e3652 = (_e884 + ((_e3611 - _e885) * (_e888 / _e891)));
let _e3653 = (_e3641 != _e3616);
let _e3660 = -(select(_e3645, select(_e3652, _e3645, (_e3645 < _e3652)), _e3653));
let _e3662 = select(_e3576, _e3660, (_e3660 > _e3576));
let _e3664 = select(65536f, _e3662, (_e3662 < 65536f));
let _e3671 = select(0i, select(select(i32(_e3664), i32(-2147483648), (_e3664 < -2147483600f)), 2147483647i, (_e3664 > 2147483500f)), (_e3664 == _e3664));
phi_1818_ = -((_e3671 - select(0i, 1i, (_e3664 < f32(_e3671)))));
loop {
let _e3678 = phi_1818_;
let _e3680 = (f32(_e3678) < select(_e3648, select(_e3652, _e3648, (_e3648 > _e3652)), _e3653));
if _e3680 {
if _e877 {
let _e3768 = global_1.member.member_12.member_17.member;
let _e3769 = bitcast<i32>(_e3768);
let _e3774 = global_1.member.member_12.member_17.member_1;
let _e3776 = (_e3678 + 1i);
let _e3777 = (_e3609 + 1i);
if ((((_e3776 >= 0i) && (_e3776 < _e3769)) && (_e3777 >= 0i)) && (_e3777 < bitcast<i32>(_e3774))) {
phi_1861_ = ((_e3777 * _e3769) + _e3776);
} else {
phi_1861_ = -1i;
}
let _e3788 = phi_1861_;
phi_1950_ = _e3788;
} else {
let _e3684 = global_1.member.member_12.member_15;
let _e3685 = bitcast<i32>(_e3684);
let _e3687 = (firstTrailingBit(8u) & 31u);
let _e3689 = (_e3678 >> bitcast<u32>(_e3687));
let _e3691 = (_e3609 >> bitcast<u32>(_e3687));
let _e3696 = global_1.member.member_12.member_14.member;
let _e3697 = bitcast<i32>(_e3696);
let _e3702 = global_1.member.member_12.member_14.member_1;
let _e3703 = bitcast<i32>(_e3702);
let _e3708 = global_1.member.member_12.member_14.member_2;
if ((((((_e3689 >= 0i) && (_e3689 < _e3697)) && (_e3691 >= 0i)) && (_e3691 < _e3703)) && (_e3685 >= 0i)) && (_e3685 < bitcast<i32>(_e3708))) {
phi_1905_ = (((((_e3685 * _e3703) + _e3691) * _e3697) + _e3689) * 3i);
} else {
phi_1905_ = -1i;
}
let _e3727 = phi_1905_;
let _e3728 = (_e3727 + 2i);
let _e3730 = (bitcast<i32>(_e61) - 1i);
let _e3732 = select(_e3730, _e3728, (_e3728 < _e3730));
let _e3737 = global_2.member[bitcast<u32>(select(0i, _e3732, (_e3732 > 0i)))];
let _e3738 = bitcast<i32>(_e3737);
if ((_e3727 < 0i) || (_e3738 == 0i)) {
phi_1949_ = -1i;
} else {
let _e3753 = global_1.member.member_12.member_17.member;
let _e3758 = global_1.member.member_12.member_17.member_1;
phi_1949_ = (bitcast<i32>((_e3753 * _e3758)) + ((((_e3738 - 1i) * 64i) + ((_e3609 & 7i) * 8i)) + (_e3678 & 7i)));
}
let _e3763 = phi_1949_;
phi_1950_ = _e3763;
}
let _e3790 = phi_1950_;
if (_e3790 >= 0i) {
let _e3792 = (_e3790 * 6i);
let _e3797 = (((_e80.member_2 == 3u) || (_e80.member_2 == 4u)) || (_e80.member_2 == 5u));
let _e3799 = bitcast<u32>(_e3495);
let _e3803 = bitcast<u32>((select((_e3508 - select(0i, 1i, (_e3501 < f32(_e3508)))), 0i, _e3797) + (_e3495 >> bitcast<u32>(31i))));
if ((_e3799 | _e3803) == 0u) {
} else {
let _e3806 = bitcast<u32>(_e3792);
if (_e3806 < _e64) {
let _e3809 = atomicAdd((&global_5.member[_e3806]), _e3799);
phi_1984_ = _e3809;
} else {
phi_1984_ = 0u;
}
let _e3811 = phi_1984_;
let _e3815 = (_e3803 + select(0u, 1u, ((_e3811 + _e3799) < _e3799)));
if (_e3815 == 0u) {
} else {
let _e3817 = (_e3806 + 1u);
if (_e3817 < _e64) {
let _e3820 = atomicAdd((&global_5.member[_e3817]), _e3815);
}
}
}
if _e3797 {
} else {
let _e3822 = bitcast<u32>(_e3529);
let _e3825 = bitcast<u32>((_e3529 >> bitcast<u32>(31i)));
if ((_e3822 | _e3825) == 0u) {
} else {
let _e3828 = bitcast<u32>((_e3792 + 4i));
if (_e3828 < _e64) {
let _e3831 = atomicAdd((&global_5.member[_e3828]), _e3822);
phi_2026_ = _e3831;
} else {
phi_2026_ = 0u;
}
let _e3833 = phi_2026_;
let _e3837 = (_e3825 + select(0u, 1u, ((_e3833 + _e3822) < _e3822)));
if (_e3837 == 0u) {
} else {
let _e3839 = (_e3828 + 1u);
if (_e3839 < _e64) {
let _e3842 = atomicAdd((&global_5.member[_e3839]), _e3837);
}
}
}
}
let _e3845 = global_1.member.member_22;
if (_e3845 > 0f) {
let _e3848 = bitcast<u32>(_e3546);
let _e3852 = bitcast<u32>(((_e3559 - select(0i, 1i, (_e3552 < f32(_e3559)))) + (_e3546 >> bitcast<u32>(31i))));
if ((_e3848 | _e3852) == 0u) {
} else {
let _e3855 = bitcast<u32>((_e3792 + 2i));
if (_e3855 < _e64) {
let _e3858 = atomicAdd((&global_5.member[_e3855]), _e3848);
phi_2066_ = _e3858;
} else {
phi_2066_ = 0u;
}
let _e3860 = phi_2066_;
let _e3864 = (_e3852 + select(0u, 1u, ((_e3860 + _e3848) < _e3848)));
if (_e3864 == 0u) {
} else {
let _e3866 = (_e3855 + 1u);
if (_e3866 < _e64) {
let _e3869 = atomicAdd((&global_5.member[_e3866]), _e3864);
}
}
}
}
}
phi_1819_ = (_e3678 + 1i);
} else {
phi_1819_ = i32();
}
let _e3872 = phi_1819_;
continue;
continuing {
phi_1818_ = _e3872;
break if !(_e3680);
}
}
phi_1671_ = (_e3609 + 1i);
} else {
phi_1671_ = i32();
}
let _e3876 = phi_1671_;
continue;
continuing {
phi_1670_ = _e3876;
break if !(_e3610);
}
}
} else {
let _e951 = select(1f, 0f, _e931);
let _e952 = select(1f, 0f, _e932);
let _e953 = select(1f, 0f, _e934);
let _e955 = ((_e951 + _e952) + _e953);
let _e959 = (_e603 * _e952);
let _e960 = (_e614 * _e952);
let _e961 = (_e625 * _e952);
let _e965 = (_e691 * _e953);
let _e966 = (_e702 * _e953);
let _e967 = (_e713 * _e953);
let _e973 = (1f / 3f);
let _e974 = (((_e516 + _e527) + _e538) * _e973);
let _e981 = (((_e603 + _e614) + _e625) * _e973);
let _e984 = ((_e636 * _e981) * _e952);
let _e985 = ((_e647 * _e981) * _e952);
let _e990 = (((_e691 + _e702) + _e713) * _e973);
let _e993 = ((_e724 * _e990) * _e953);
let _e994 = ((_e735 * _e990) * _e953);
let _e997 = (1f / 6f);
let _e998 = ((((_e516 * _e951) + _e959) + _e965) * _e997);
let _e999 = ((((_e527 * _e951) + _e960) + _e966) * _e997);
let _e1000 = ((((_e538 * _e951) + _e961) + _e967) * _e997);
let _e1001 = (((((_e549 * _e974) * _e951) + _e984) + _e993) * _e997);
let _e1002 = (((((_e560 * _e974) * _e951) + _e985) + _e994) * _e997);
let _e1004 = select(_e882, _e880, (_e880 < _e882));
let _e1008 = select(_e883, _e881, (_e881 < _e883));
let _e1010 = select(_e885, _e1008, (_e1008 < _e885));
let _e1012 = select(_e882, _e880, (_e880 > _e882));
let _e1016 = select(_e883, _e881, (_e881 > _e883));
let _e1018 = select(_e885, _e1016, (_e1016 > _e885));
let _e1019 = (select(_e884, _e1012, (_e1012 > _e884)) - select(_e884, _e1004, (_e1004 < _e884)));
let _e1020 = (_e1018 - _e1010);
let _e1022 = select(_e1020, _e1019, (_e1019 > _e1020));
let _e1023 = (_e884 - _e880);
let _e1024 = (_e885 - _e881);
let _e1031 = (0.5f * bitcast<f32>((bitcast<u32>(((_e895 * _e1024) - (_e898 * _e1023))) & 2147483647u)));
let _e1032 = (_e955 == 3f);
let _e1033 = (64f / _e878);
let _e1037 = (_e1022 <= _e1033);
if ((_e1032 && ((2f * _e1031) >= 0.5f)) && _e1037) {
let _e1813 = global_1.member.member_12.member_22;
let _e1814 = (_e1813 * ((1f / _e1031) / (_e878 * _e878)));
let _e1816 = ((_e998 * _e1814) + 0.5f);
let _e1818 = select(-1073741800f, _e1816, (_e1816 > -1073741800f));
let _e1820 = select(1073741800f, _e1818, (_e1818 < 1073741800f));
let _e1827 = select(0i, select(select(i32(_e1820), i32(-2147483648), (_e1820 < -2147483600f)), 2147483647i, (_e1820 > 2147483500f)), (_e1820 == _e1820));
let _e1831 = (_e1827 - select(0i, 1i, (_e1820 < f32(_e1827))));
let _e1833 = ((_e999 * _e1814) + 0.5f);
let _e1835 = select(-1073741800f, _e1833, (_e1833 > -1073741800f));
let _e1837 = select(1073741800f, _e1835, (_e1835 < 1073741800f));
let _e1844 = select(0i, select(select(i32(_e1837), i32(-2147483648), (_e1837 < -2147483600f)), 2147483647i, (_e1837 > 2147483500f)), (_e1837 == _e1837));
let _e1850 = ((_e1000 * _e1814) + 0.5f);
let _e1852 = select(-1073741800f, _e1850, (_e1850 > -1073741800f));
let _e1854 = select(1073741800f, _e1852, (_e1852 < 1073741800f));
let _e1861 = select(0i, select(select(i32(_e1854), i32(-2147483648), (_e1854 < -2147483600f)), 2147483647i, (_e1854 > 2147483500f)), (_e1854 == _e1854));
let _e1865 = (_e1861 - select(0i, 1i, (_e1854 < f32(_e1861))));
let _e1867 = ((_e1001 * _e1814) + 0.5f);
let _e1869 = select(-1073741800f, _e1867, (_e1867 > -1073741800f));
let _e1871 = select(1073741800f, _e1869, (_e1869 < 1073741800f));
let _e1878 = select(0i, select(select(i32(_e1871), i32(-2147483648), (_e1871 < -2147483600f)), 2147483647i, (_e1871 > 2147483500f)), (_e1871 == _e1871));
let _e1882 = (_e1878 - select(0i, 1i, (_e1871 < f32(_e1878))));
let _e1884 = ((_e1002 * _e1814) + 0.5f);
let _e1886 = select(-1073741800f, _e1884, (_e1884 > -1073741800f));
let _e1888 = select(1073741800f, _e1886, (_e1886 < 1073741800f));
let _e1895 = select(0i, select(select(i32(_e1888), i32(-2147483648), (_e1888 < -2147483600f)), 2147483647i, (_e1888 > 2147483500f)), (_e1888 == _e1888));
let _e1900 = -(65536f);
let _e1902 = select(_e1900, _e1010, (_e1010 > _e1900));
let _e1904 = select(65536f, _e1902, (_e1902 < 65536f));
let _e1911 = select(0i, select(select(i32(_e1904), i32(-2147483648), (_e1904 < -2147483600f)), 2147483647i, (_e1904 > 2147483500f)), (_e1904 == _e1904));
let _e1918 = select(_e1900, _e1018, (_e1018 > _e1900));
let _e1920 = select(65536f, _e1918, (_e1918 < 65536f));
let _e1927 = select(0i, select(select(i32(_e1920), i32(-2147483648), (_e1920 < -2147483600f)), 2147483647i, (_e1920 > 2147483500f)), (_e1920 == _e1920));
phi_2530_ = ((_e1911 - select(0i, 1i, (_e1904 < f32(_e1911)))) + 1i);
loop {
let _e1933 = phi_2530_;
let _e1934 = (_e1933 <= (_e1927 - select(0i, 1i, (_e1920 < f32(_e1927)))));
if _e1934 {
let _e1935 = f32(_e1933);
let _e1939 = (_e880 + ((_e1935 - _e881) * (_e895 / _e898)));
let _e1940 = (_e881 <= _e1935);
let _e1941 = (_e883 <= _e1935);
let _e1942 = (_e1940 != _e1941);
let _e1945 = select(65536f, select(_e1939, 65536f, (65536f < _e1939)), _e1942);
let _e1948 = select(_e1900, select(_e1939, _e1900, (_e1900 > _e1939)), _e1942);
let _e1952 = (_e882 + ((_e1935 - _e883) * (_e906 / _e903)));
let _e1953 = (_e885 <= _e1935);
let _e1954 = (_e1941 != _e1953);
let _e1957 = select(_e1945, select(_e1952, _e1945, (_e1945 < _e1952)), _e1954);
let _e1960 = select(_e1948, select(_e1952, _e1948, (_e1948 > _e1952)), _e1954);
let _e1961 = (_e1935 - _e885);
let _e1966 = (_e884 + (_e1961 * ((_e884 - _e884) / (_e885 - _e885))));
let _e1967 = (_e1953 != _e1953);
let _e1970 = select(_e1957, select(_e1966, _e1957, (_e1957 < _e1966)), _e1967);
let _e1973 = select(_e1960, select(_e1966, _e1960, (_e1960 > _e1966)), _e1967);
let _e1976 = (_e884 + (_e1961 * (_e888 / _e891)));
let _e1977 = (_e1953 != _e1940);
let _e1984 = -(select(_e1970, select(_e1976, _e1970, (_e1970 < _e1976)), _e1977));
let _e1986 = select(_e1900, _e1984, (_e1984 > _e1900));
let _e1988 = select(65536f, _e1986, (_e1986 < 65536f));
let _e1995 = select(0i, select(select(i32(_e1988), i32(-2147483648), (_e1988 < -2147483600f)), 2147483647i, (_e1988 > 2147483500f)), (_e1988 == _e1988));
phi_2678_ = -((_e1995 - select(0i, 1i, (_e1988 < f32(_e1995)))));
loop {
let _e2002 = phi_2678_;
let _e2004 = (f32(_e2002) < select(_e1973, select(_e1976, _e1973, (_e1973 > _e1976)), _e1977));
if _e2004 {
if _e877 {
let _e2092 = global_1.member.member_12.member_17.member;
let _e2093 = bitcast<i32>(_e2092);
let _e2098 = global_1.member.member_12.member_17.member_1;
let _e2100 = (_e2002 + 1i);
let _e2101 = (_e1933 + 1i);
if ((((_e2100 >= 0i) && (_e2100 < _e2093)) && (_e2101 >= 0i)) && (_e2101 < bitcast<i32>(_e2098))) {
phi_2721_ = ((_e2101 * _e2093) + _e2100);
} else {
phi_2721_ = -1i;
}
let _e2112 = phi_2721_;
phi_2810_ = _e2112;
} else {
let _e2008 = global_1.member.member_12.member_15;
let _e2009 = bitcast<i32>(_e2008);
let _e2011 = (firstTrailingBit(8u) & 31u);
let _e2013 = (_e2002 >> bitcast<u32>(_e2011));
let _e2015 = (_e1933 >> bitcast<u32>(_e2011));
let _e2020 = global_1.member.member_12.member_14.member;
let _e2021 = bitcast<i32>(_e2020);
let _e2026 = global_1.member.member_12.member_14.member_1;
let _e2027 = bitcast<i32>(_e2026);
let _e2032 = global_1.member.member_12.member_14.member_2;
if ((((((_e2013 >= 0i) && (_e2013 < _e2021)) && (_e2015 >= 0i)) && (_e2015 < _e2027)) && (_e2009 >= 0i)) && (_e2009 < bitcast<i32>(_e2032))) {
phi_2765_ = (((((_e2009 * _e2027) + _e2015) * _e2021) + _e2013) * 3i);
} else {
phi_2765_ = -1i;
}
let _e2051 = phi_2765_;
let _e2052 = (_e2051 + 2i);
let _e2054 = (bitcast<i32>(_e61) - 1i);
let _e2056 = select(_e2054, _e2052, (_e2052 < _e2054));
let _e2061 = global_2.member[bitcast<u32>(select(0i, _e2056, (_e2056 > 0i)))];
let _e2062 = bitcast<i32>(_e2061);
if ((_e2051 < 0i) || (_e2062 == 0i)) {
phi_2809_ = -1i;
} else {
let _e2077 = global_1.member.member_12.member_17.member;
let _e2082 = global_1.member.member_12.member_17.member_1;
phi_2809_ = (bitcast<i32>((_e2077 * _e2082)) + ((((_e2062 - 1i) * 64i) + ((_e1933 & 7i) * 8i)) + (_e2002 & 7i)));
}
let _e2087 = phi_2809_;
phi_2810_ = _e2087;
}
let _e2114 = phi_2810_;
if (_e2114 >= 0i) {
let _e2116 = (_e2114 * 6i);
let _e2121 = (((_e80.member_2 == 3u) || (_e80.member_2 == 4u)) || (_e80.member_2 == 5u));
let _e2123 = bitcast<u32>(_e1831);
let _e2127 = bitcast<u32>((select((_e1844 - select(0i, 1i, (_e1837 < f32(_e1844)))), 0i, _e2121) + (_e1831 >> bitcast<u32>(31i))));
if ((_e2123 | _e2127) == 0u) {
} else {
let _e2130 = bitcast<u32>(_e2116);
if (_e2130 < _e64) {
let _e2133 = atomicAdd((&global_5.member[_e2130]), _e2123);
phi_2844_ = _e2133;
} else {
phi_2844_ = 0u;
}
let _e2135 = phi_2844_;
let _e2139 = (_e2127 + select(0u, 1u, ((_e2135 + _e2123) < _e2123)));
if (_e2139 == 0u) {
} else {
let _e2141 = (_e2130 + 1u);
if (_e2141 < _e64) {
let _e2144 = atomicAdd((&global_5.member[_e2141]), _e2139);
}
}
}
if _e2121 {
} else {
let _e2146 = bitcast<u32>(_e1865);
let _e2149 = bitcast<u32>((_e1865 >> bitcast<u32>(31i)));
if ((_e2146 | _e2149) == 0u) {
} else {
let _e2152 = bitcast<u32>((_e2116 + 4i));
if (_e2152 < _e64) {
let _e2155 = atomicAdd((&global_5.member[_e2152]), _e2146);
phi_2886_ = _e2155;
} else {
phi_2886_ = 0u;
}
let _e2157 = phi_2886_;
let _e2161 = (_e2149 + select(0u, 1u, ((_e2157 + _e2146) < _e2146)));
if (_e2161 == 0u) {
} else {
let _e2163 = (_e2152 + 1u);
if (_e2163 < _e64) {
let _e2166 = atomicAdd((&global_5.member[_e2163]), _e2161);
}
}
}
}
let _e2169 = global_1.member.member_22;
if (_e2169 > 0f) {
let _e2172 = bitcast<u32>(_e1882);
let _e2176 = bitcast<u32>(((_e1895 - select(0i, 1i, (_e1888 < f32(_e1895)))) + (_e1882 >> bitcast<u32>(31i))));
if ((_e2172 | _e2176) == 0u) {
} else {
let _e2179 = bitcast<u32>((_e2116 + 2i));
if (_e2179 < _e64) {
let _e2182 = atomicAdd((&global_5.member[_e2179]), _e2172);
phi_2926_ = _e2182;
} else {
phi_2926_ = 0u;
}
let _e2184 = phi_2926_;
let _e2188 = (_e2176 + select(0u, 1u, ((_e2184 + _e2172) < _e2172)));
if (_e2188 == 0u) {
} else {
let _e2190 = (_e2179 + 1u);
if (_e2190 < _e64) {
let _e2193 = atomicAdd((&global_5.member[_e2190]), _e2188);
}
}
}
}
}
phi_2679_ = (_e2002 + 1i);
} else {
phi_2679_ = i32();
}
let _e2196 = phi_2679_;
continue;
continuing {
phi_2678_ = _e2196;
break if !(_e2004);
}
}
phi_2531_ = (_e1933 + 1i);
} else {
phi_2531_ = i32();
}
let _e2200 = phi_2531_;
continue;
continuing {
phi_2530_ = _e2200;
break if !(_e1934);
}
}
} else {
if ((_e1032 && (_e1022 > 2f)) && _e1037) {
let _e1412 = (bitcast<f32>((bitcast<u32>(_e895) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e898) & 2147483647u)));
let _e1419 = (bitcast<f32>((bitcast<u32>(_e1023) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1024) & 2147483647u)));
let _e1420 = (_e1412 > _e1419);
let _e1422 = ((bitcast<f32>((bitcast<u32>(_e906) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e903) & 2147483647u))) > select(_e1419, _e1412, _e1420));
if _e1422 {
phi_2979_ = vec2<f32>(_e906, _e903);
} else {
if _e1420 {
phi_2978_ = vec2<f32>(_e895, _e898);
} else {
phi_2978_ = vec2<f32>(_e1023, _e1024);
}
let _e1426 = phi_2978_;
phi_2979_ = _e1426;
}
let _e1428 = phi_2979_;
if _e1422 {
phi_2989_ = vec2<f32>(_e882, _e883);
} else {
phi_2989_ = vec2<f32>(_e880, _e881);
}
let _e1432 = phi_2989_;
let _e1434 = select(1f, _e1022, (_e1022 > 1f));
let _e1436 = select(64f, _e1434, (_e1434 < 64f));
let _e1443 = select(0i, select(select(i32(_e1436), i32(-2147483648), (_e1436 < -2147483600f)), 2147483647i, (_e1436 > 2147483500f)), (_e1436 == _e1436));
let _e1448 = ((_e1443 - select(0i, 1i, (_e1436 < f32(_e1443)))) + 1i);
let _e1450 = (1f / f32(_e1448));
phi_3020_ = 0i;
loop {
let _e1452 = phi_3020_;
let _e1453 = (_e1452 < _e1448);
if _e1453 {
let _e1460 = ((f32(_e1452) + 0.5f) * _e1450);
let _e1463 = (_e1432.x + (_e1428.x * _e1460));
let _e1464 = (_e1432.y + (_e1428.y * _e1460));
let _e1465 = -(65536f);
let _e1467 = select(_e1465, _e1463, (_e1463 > _e1465));
let _e1469 = select(65536f, _e1467, (_e1467 < 65536f));
let _e1476 = select(0i, select(select(i32(_e1469), i32(-2147483648), (_e1469 < -2147483600f)), 2147483647i, (_e1469 > 2147483500f)), (_e1469 == _e1469));
let _e1480 = (_e1476 - select(0i, 1i, (_e1469 < f32(_e1476))));
let _e1482 = select(_e1465, _e1464, (_e1464 > _e1465));
let _e1484 = select(65536f, _e1482, (_e1482 < 65536f));
let _e1491 = select(0i, select(select(i32(_e1484), i32(-2147483648), (_e1484 < -2147483600f)), 2147483647i, (_e1484 > 2147483500f)), (_e1484 == _e1484));
let _e1495 = (_e1491 - select(0i, 1i, (_e1484 < f32(_e1491))));
let _e1497 = (_e1463 - f32(_e1480));
let _e1499 = (_e1464 - f32(_e1495));
phi_3103_ = 0i;
loop {
let _e1501 = phi_3103_;
let _e1502 = (_e1501 < 4i);
if _e1502 {
let _e1503 = (_e1501 & 1i);
let _e1505 = (_e1501 >> bitcast<u32>(1i));
if (_e1503 == 0i) {
phi_3118_ = (1f - _e1497);
} else {
phi_3118_ = _e1497;
}
let _e1509 = phi_3118_;
if (_e1505 == 0i) {
phi_3124_ = (1f - _e1499);
} else {
phi_3124_ = _e1499;
}
let _e1513 = phi_3124_;
let _e1521 = global_1.member.member_12.member_22;
let _e1522 = (_e1521 * (((_e1450 * _e1509) * _e1513) / (_e878 * _e878)));
let _e1524 = ((_e998 * _e1522) + 0.5f);
let _e1526 = select(-1073741800f, _e1524, (_e1524 > -1073741800f));
let _e1528 = select(1073741800f, _e1526, (_e1526 < 1073741800f));
let _e1535 = select(0i, select(select(i32(_e1528), i32(-2147483648), (_e1528 < -2147483600f)), 2147483647i, (_e1528 > 2147483500f)), (_e1528 == _e1528));
let _e1539 = (_e1535 - select(0i, 1i, (_e1528 < f32(_e1535))));
let _e1541 = ((_e999 * _e1522) + 0.5f);
let _e1543 = select(-1073741800f, _e1541, (_e1541 > -1073741800f));
let _e1545 = select(1073741800f, _e1543, (_e1543 < 1073741800f));
let _e1552 = select(0i, select(select(i32(_e1545), i32(-2147483648), (_e1545 < -2147483600f)), 2147483647i, (_e1545 > 2147483500f)), (_e1545 == _e1545));
let _e1558 = ((_e1000 * _e1522) + 0.5f);
let _e1560 = select(-1073741800f, _e1558, (_e1558 > -1073741800f));
let _e1562 = select(1073741800f, _e1560, (_e1560 < 1073741800f));
let _e1569 = select(0i, select(select(i32(_e1562), i32(-2147483648), (_e1562 < -2147483600f)), 2147483647i, (_e1562 > 2147483500f)), (_e1562 == _e1562));
let _e1573 = (_e1569 - select(0i, 1i, (_e1562 < f32(_e1569))));
let _e1575 = ((_e1001 * _e1522) + 0.5f);
let _e1577 = select(-1073741800f, _e1575, (_e1575 > -1073741800f));
let _e1579 = select(1073741800f, _e1577, (_e1577 < 1073741800f));
let _e1586 = select(0i, select(select(i32(_e1579), i32(-2147483648), (_e1579 < -2147483600f)), 2147483647i, (_e1579 > 2147483500f)), (_e1579 == _e1579));
let _e1590 = (_e1586 - select(0i, 1i, (_e1579 < f32(_e1586))));
let _e1592 = ((_e1002 * _e1522) + 0.5f);
let _e1594 = select(-1073741800f, _e1592, (_e1592 > -1073741800f));
let _e1596 = select(1073741800f, _e1594, (_e1594 < 1073741800f));
let _e1603 = select(0i, select(select(i32(_e1596), i32(-2147483648), (_e1596 < -2147483600f)), 2147483647i, (_e1596 > 2147483500f)), (_e1596 == _e1596));
let _e1608 = (_e1480 + _e1503);
let _e1609 = (_e1495 + _e1505);
if _e877 {
let _e1697 = global_1.member.member_12.member_17.member;
let _e1698 = bitcast<i32>(_e1697);
let _e1703 = global_1.member.member_12.member_17.member_1;
let _e1705 = (_e1608 + 1i);
let _e1706 = (_e1609 + 1i);
if ((((_e1705 >= 0i) && (_e1705 < _e1698)) && (_e1706 >= 0i)) && (_e1706 < bitcast<i32>(_e1703))) {
phi_3299_ = ((_e1706 * _e1698) + _e1705);
} else {
phi_3299_ = -1i;
}
let _e1717 = phi_3299_;
phi_3388_ = _e1717;
} else {
let _e1613 = global_1.member.member_12.member_15;
let _e1614 = bitcast<i32>(_e1613);
let _e1616 = (firstTrailingBit(8u) & 31u);
let _e1618 = (_e1608 >> bitcast<u32>(_e1616));
let _e1620 = (_e1609 >> bitcast<u32>(_e1616));
let _e1625 = global_1.member.member_12.member_14.member;
let _e1626 = bitcast<i32>(_e1625);
let _e1631 = global_1.member.member_12.member_14.member_1;
let _e1632 = bitcast<i32>(_e1631);
let _e1637 = global_1.member.member_12.member_14.member_2;
if ((((((_e1618 >= 0i) && (_e1618 < _e1626)) && (_e1620 >= 0i)) && (_e1620 < _e1632)) && (_e1614 >= 0i)) && (_e1614 < bitcast<i32>(_e1637))) {
phi_3343_ = (((((_e1614 * _e1632) + _e1620) * _e1626) + _e1618) * 3i);
} else {
phi_3343_ = -1i;
}
let _e1656 = phi_3343_;
let _e1657 = (_e1656 + 2i);
let _e1659 = (bitcast<i32>(_e61) - 1i);
let _e1661 = select(_e1659, _e1657, (_e1657 < _e1659));
let _e1666 = global_2.member[bitcast<u32>(select(0i, _e1661, (_e1661 > 0i)))];
let _e1667 = bitcast<i32>(_e1666);
if ((_e1656 < 0i) || (_e1667 == 0i)) {
phi_3387_ = -1i;
} else {
let _e1682 = global_1.member.member_12.member_17.member;
let _e1687 = global_1.member.member_12.member_17.member_1;
phi_3387_ = (bitcast<i32>((_e1682 * _e1687)) + ((((_e1667 - 1i) * 64i) + ((_e1609 & 7i) * 8i)) + (_e1608 & 7i)));
}
let _e1692 = phi_3387_;
phi_3388_ = _e1692;
}
let _e1719 = phi_3388_;
if (_e1719 >= 0i) {
let _e1721 = (_e1719 * 6i);
let _e1726 = (((_e80.member_2 == 3u) || (_e80.member_2 == 4u)) || (_e80.member_2 == 5u));
let _e1728 = bitcast<u32>(_e1539);
let _e1732 = bitcast<u32>((select((_e1552 - select(0i, 1i, (_e1545 < f32(_e1552)))), 0i, _e1726) + (_e1539 >> bitcast<u32>(31i))));
if ((_e1728 | _e1732) == 0u) {
} else {
let _e1735 = bitcast<u32>(_e1721);
if (_e1735 < _e64) {
let _e1738 = atomicAdd((&global_5.member[_e1735]), _e1728);
phi_3422_ = _e1738;
} else {
phi_3422_ = 0u;
}
let _e1740 = phi_3422_;
let _e1744 = (_e1732 + select(0u, 1u, ((_e1740 + _e1728) < _e1728)));
if (_e1744 == 0u) {
} else {
let _e1746 = (_e1735 + 1u);
if (_e1746 < _e64) {
let _e1749 = atomicAdd((&global_5.member[_e1746]), _e1744);
}
}
}
if _e1726 {
} else {
let _e1751 = bitcast<u32>(_e1573);
let _e1754 = bitcast<u32>((_e1573 >> bitcast<u32>(31i)));
if ((_e1751 | _e1754) == 0u) {
} else {
let _e1757 = bitcast<u32>((_e1721 + 4i));
if (_e1757 < _e64) {
let _e1760 = atomicAdd((&global_5.member[_e1757]), _e1751);
phi_3464_ = _e1760;
} else {
phi_3464_ = 0u;
}
let _e1762 = phi_3464_;
let _e1766 = (_e1754 + select(0u, 1u, ((_e1762 + _e1751) < _e1751)));
if (_e1766 == 0u) {
} else {
let _e1768 = (_e1757 + 1u);
if (_e1768 < _e64) {
let _e1771 = atomicAdd((&global_5.member[_e1768]), _e1766);
}
}
}
}
let _e1774 = global_1.member.member_22;
if (_e1774 > 0f) {
let _e1777 = bitcast<u32>(_e1590);
let _e1781 = bitcast<u32>(((_e1603 - select(0i, 1i, (_e1596 < f32(_e1603)))) + (_e1590 >> bitcast<u32>(31i))));
if ((_e1777 | _e1781) == 0u) {
} else {
let _e1784 = bitcast<u32>((_e1721 + 2i));
if (_e1784 < _e64) {
let _e1787 = atomicAdd((&global_5.member[_e1784]), _e1777);
phi_3504_ = _e1787;
} else {
phi_3504_ = 0u;
}
let _e1789 = phi_3504_;
let _e1793 = (_e1781 + select(0u, 1u, ((_e1789 + _e1777) < _e1777)));
if (_e1793 == 0u) {
} else {
let _e1795 = (_e1784 + 1u);
if (_e1795 < _e64) {
let _e1798 = atomicAdd((&global_5.member[_e1795]), _e1793);
}
}
}
}
}
phi_3104_ = (_e1501 + 1i);
} else {
phi_3104_ = i32();
}
let _e1801 = phi_3104_;
continue;
continuing {
phi_3103_ = _e1801;
break if !(_e1502);
}
}
phi_3021_ = (_e1452 + 1i);
} else {
phi_3021_ = i32();
}
let _e1805 = phi_3021_;
continue;
continuing {
phi_3020_ = _e1805;
break if !(_e1453);
}
}
} else {
if ((_e955 > 0f) && (!(_e1032) || (_e1022 <= 2f))) {
let _e1057 = (1f / _e955);
let _e1058 = ((((_e880 * _e951) + (_e882 * _e952)) + (_e884 * _e953)) * _e1057);
let _e1059 = ((((_e881 * _e951) + (_e883 * _e952)) + (_e885 * _e953)) * _e1057);
let _e1060 = -(65536f);
let _e1062 = select(_e1060, _e1058, (_e1058 > _e1060));
let _e1064 = select(65536f, _e1062, (_e1062 < 65536f));
let _e1071 = select(0i, select(select(i32(_e1064), i32(-2147483648), (_e1064 < -2147483600f)), 2147483647i, (_e1064 > 2147483500f)), (_e1064 == _e1064));
let _e1075 = (_e1071 - select(0i, 1i, (_e1064 < f32(_e1071))));
let _e1077 = select(_e1060, _e1059, (_e1059 > _e1060));
let _e1079 = select(65536f, _e1077, (_e1077 < 65536f));
let _e1086 = select(0i, select(select(i32(_e1079), i32(-2147483648), (_e1079 < -2147483600f)), 2147483647i, (_e1079 > 2147483500f)), (_e1079 == _e1079));
let _e1090 = (_e1086 - select(0i, 1i, (_e1079 < f32(_e1086))));
let _e1092 = (_e1058 - f32(_e1075));
let _e1094 = (_e1059 - f32(_e1090));
phi_3613_ = 0i;
loop {
let _e1096 = phi_3613_;
let _e1097 = (_e1096 < 4i);
if _e1097 {
let _e1098 = (_e1096 & 1i);
let _e1100 = (_e1096 >> bitcast<u32>(1i));
if (_e1098 == 0i) {
phi_3628_ = (1f - _e1092);
} else {
phi_3628_ = _e1092;
}
let _e1104 = phi_3628_;
if (_e1100 == 0i) {
phi_3634_ = (1f - _e1094);
} else {
phi_3634_ = _e1094;
}
let _e1108 = phi_3634_;
let _e1116 = global_1.member.member_12.member_22;
let _e1117 = (_e1116 * (((1f * _e1104) * _e1108) / (_e878 * _e878)));
let _e1119 = ((_e998 * _e1117) + 0.5f);
let _e1121 = select(-1073741800f, _e1119, (_e1119 > -1073741800f));
let _e1123 = select(1073741800f, _e1121, (_e1121 < 1073741800f));
let _e1130 = select(0i, select(select(i32(_e1123), i32(-2147483648), (_e1123 < -2147483600f)), 2147483647i, (_e1123 > 2147483500f)), (_e1123 == _e1123));
let _e1134 = (_e1130 - select(0i, 1i, (_e1123 < f32(_e1130))));
let _e1136 = ((_e999 * _e1117) + 0.5f);
let _e1138 = select(-1073741800f, _e1136, (_e1136 > -1073741800f));
let _e1140 = select(1073741800f, _e1138, (_e1138 < 1073741800f));
let _e1147 = select(0i, select(select(i32(_e1140), i32(-2147483648), (_e1140 < -2147483600f)), 2147483647i, (_e1140 > 2147483500f)), (_e1140 == _e1140));
let _e1153 = ((_e1000 * _e1117) + 0.5f);
let _e1155 = select(-1073741800f, _e1153, (_e1153 > -1073741800f));
let _e1157 = select(1073741800f, _e1155, (_e1155 < 1073741800f));
let _e1164 = select(0i, select(select(i32(_e1157), i32(-2147483648), (_e1157 < -2147483600f)), 2147483647i, (_e1157 > 2147483500f)), (_e1157 == _e1157));
let _e1168 = (_e1164 - select(0i, 1i, (_e1157 < f32(_e1164))));
let _e1170 = ((_e1001 * _e1117) + 0.5f);
let _e1172 = select(-1073741800f, _e1170, (_e1170 > -1073741800f));
let _e1174 = select(1073741800f, _e1172, (_e1172 < 1073741800f));
let _e1181 = select(0i, select(select(i32(_e1174), i32(-2147483648), (_e1174 < -2147483600f)), 2147483647i, (_e1174 > 2147483500f)), (_e1174 == _e1174));
let _e1185 = (_e1181 - select(0i, 1i, (_e1174 < f32(_e1181))));
let _e1187 = ((_e1002 * _e1117) + 0.5f);
let _e1189 = select(-1073741800f, _e1187, (_e1187 > -1073741800f));
let _e1191 = select(1073741800f, _e1189, (_e1189 < 1073741800f));
let _e1198 = select(0i, select(select(i32(_e1191), i32(-2147483648), (_e1191 < -2147483600f)), 2147483647i, (_e1191 > 2147483500f)), (_e1191 == _e1191));
let _e1203 = (_e1075 + _e1098);
let _e1204 = (_e1090 + _e1100);
if _e877 {
let _e1292 = global_1.member.member_12.member_17.member;
let _e1293 = bitcast<i32>(_e1292);
let _e1298 = global_1.member.member_12.member_17.member_1;
let _e1300 = (_e1203 + 1i);
let _e1301 = (_e1204 + 1i);
if ((((_e1300 >= 0i) && (_e1300 < _e1293)) && (_e1301 >= 0i)) && (_e1301 < bitcast<i32>(_e1298))) {
phi_3809_ = ((_e1301 * _e1293) + _e1300);
} else {
phi_3809_ = -1i;
}
let _e1312 = phi_3809_;
phi_3898_ = _e1312;
} else {
let _e1208 = global_1.member.member_12.member_15;
let _e1209 = bitcast<i32>(_e1208);
let _e1211 = (firstTrailingBit(8u) & 31u);
let _e1213 = (_e1203 >> bitcast<u32>(_e1211));
let _e1215 = (_e1204 >> bitcast<u32>(_e1211));
let _e1220 = global_1.member.member_12.member_14.member;
let _e1221 = bitcast<i32>(_e1220);
let _e1226 = global_1.member.member_12.member_14.member_1;
let _e1227 = bitcast<i32>(_e1226);
let _e1232 = global_1.member.member_12.member_14.member_2;
if ((((((_e1213 >= 0i) && (_e1213 < _e1221)) && (_e1215 >= 0i)) && (_e1215 < _e1227)) && (_e1209 >= 0i)) && (_e1209 < bitcast<i32>(_e1232))) {
phi_3853_ = (((((_e1209 * _e1227) + _e1215) * _e1221) + _e1213) * 3i);
} else {
phi_3853_ = -1i;
}
let _e1251 = phi_3853_;
let _e1252 = (_e1251 + 2i);
let _e1254 = (bitcast<i32>(_e61) - 1i);
let _e1256 = select(_e1254, _e1252, (_e1252 < _e1254));
let _e1261 = global_2.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1262 = bitcast<i32>(_e1261);
if ((_e1251 < 0i) || (_e1262 == 0i)) {
phi_3897_ = -1i;
} else {
let _e1277 = global_1.member.member_12.member_17.member;
let _e1282 = global_1.member.member_12.member_17.member_1;
phi_3897_ = (bitcast<i32>((_e1277 * _e1282)) + ((((_e1262 - 1i) * 64i) + ((_e1204 & 7i) * 8i)) + (_e1203 & 7i)));
}
let _e1287 = phi_3897_;
phi_3898_ = _e1287;
}
let _e1314 = phi_3898_;
if (_e1314 >= 0i) {
let _e1316 = (_e1314 * 6i);
let _e1321 = (((_e80.member_2 == 3u) || (_e80.member_2 == 4u)) || (_e80.member_2 == 5u));
let _e1323 = bitcast<u32>(_e1134);
let _e1327 = bitcast<u32>((select((_e1147 - select(0i, 1i, (_e1140 < f32(_e1147)))), 0i, _e1321) + (_e1134 >> bitcast<u32>(31i))));
if ((_e1323 | _e1327) == 0u) {
} else {
let _e1330 = bitcast<u32>(_e1316);
if (_e1330 < _e64) {
let _e1333 = atomicAdd((&global_5.member[_e1330]), _e1323);
phi_3932_ = _e1333;
} else {
phi_3932_ = 0u;
}
let _e1335 = phi_3932_;
let _e1339 = (_e1327 + select(0u, 1u, ((_e1335 + _e1323) < _e1323)));
if (_e1339 == 0u) {
} else {
let _e1341 = (_e1330 + 1u);
if (_e1341 < _e64) {
let _e1344 = atomicAdd((&global_5.member[_e1341]), _e1339);
}
}
}
if _e1321 {
} else {
let _e1346 = bitcast<u32>(_e1168);
let _e1349 = bitcast<u32>((_e1168 >> bitcast<u32>(31i)));
if ((_e1346 | _e1349) == 0u) {
} else {
let _e1352 = bitcast<u32>((_e1316 + 4i));
if (_e1352 < _e64) {
let _e1355 = atomicAdd((&global_5.member[_e1352]), _e1346);
phi_3974_ = _e1355;
} else {
phi_3974_ = 0u;
}
let _e1357 = phi_3974_;
let _e1361 = (_e1349 + select(0u, 1u, ((_e1357 + _e1346) < _e1346)));
if (_e1361 == 0u) {
} else {
let _e1363 = (_e1352 + 1u);
if (_e1363 < _e64) {
let _e1366 = atomicAdd((&global_5.member[_e1363]), _e1361);
}
}
}
}
let _e1369 = global_1.member.member_22;
if (_e1369 > 0f) {
let _e1372 = bitcast<u32>(_e1185);
let _e1376 = bitcast<u32>(((_e1198 - select(0i, 1i, (_e1191 < f32(_e1198)))) + (_e1185 >> bitcast<u32>(31i))));
if ((_e1372 | _e1376) == 0u) {
} else {
let _e1379 = bitcast<u32>((_e1316 + 2i));
if (_e1379 < _e64) {
let _e1382 = atomicAdd((&global_5.member[_e1379]), _e1372);
phi_4014_ = _e1382;
} else {
phi_4014_ = 0u;
}
let _e1384 = phi_4014_;
let _e1388 = (_e1376 + select(0u, 1u, ((_e1384 + _e1372) < _e1372)));
if (_e1388 == 0u) {
} else {
let _e1390 = (_e1379 + 1u);
if (_e1390 < _e64) {
let _e1393 = atomicAdd((&global_5.member[_e1390]), _e1388);
}
}
}
}
}
phi_3614_ = (_e1096 + 1i);
} else {
phi_3614_ = i32();
}
let _e1396 = phi_3614_;
continue;
continuing {
phi_3613_ = _e1396;
break if !(_e1097);
}
}
}
}
}
let _e2202 = select(1f, 0f, _e936);
let _e2204 = ((_e2202 + _e952) + _e953);
let _e2216 = (((_e777 + _e788) + _e799) * _e973);
let _e2225 = ((((_e777 * _e2202) + _e959) + _e965) * _e997);
let _e2226 = ((((_e788 * _e2202) + _e960) + _e966) * _e997);
let _e2227 = ((((_e799 * _e2202) + _e961) + _e967) * _e997);
let _e2228 = (((((_e810 * _e2216) * _e2202) + _e984) + _e993) * _e997);
let _e2229 = (((((_e821 * _e2216) * _e2202) + _e985) + _e994) * _e997);
let _e2231 = select(_e882, _e886, (_e886 < _e882));
let _e2235 = select(_e883, _e887, (_e887 < _e883));
let _e2237 = select(_e885, _e2235, (_e2235 < _e885));
let _e2239 = select(_e882, _e886, (_e886 > _e882));
let _e2243 = select(_e883, _e887, (_e887 > _e883));
let _e2245 = select(_e885, _e2243, (_e2243 > _e885));
let _e2246 = (select(_e884, _e2239, (_e2239 > _e884)) - select(_e884, _e2231, (_e2231 < _e884)));
let _e2247 = (_e2245 - _e2237);
let _e2249 = select(_e2247, _e2246, (_e2246 > _e2247));
let _e2250 = (_e882 - _e886);
let _e2251 = (_e883 - _e887);
let _e2258 = (0.5f * bitcast<f32>((bitcast<u32>(((_e2250 * _e912) - (_e2251 * _e909))) & 2147483647u)));
let _e2259 = (_e2204 == 3f);
let _e2263 = (_e2249 <= _e1033);
if ((_e2259 && ((2f * _e2258) >= 0.5f)) && _e2263) {
let _e3039 = global_1.member.member_12.member_22;
let _e3040 = (_e3039 * ((1f / _e2258) / (_e878 * _e878)));
let _e3042 = ((_e2225 * _e3040) + 0.5f);
let _e3044 = select(-1073741800f, _e3042, (_e3042 > -1073741800f));
let _e3046 = select(1073741800f, _e3044, (_e3044 < 1073741800f));
let _e3053 = select(0i, select(select(i32(_e3046), i32(-2147483648), (_e3046 < -2147483600f)), 2147483647i, (_e3046 > 2147483500f)), (_e3046 == _e3046));
let _e3057 = (_e3053 - select(0i, 1i, (_e3046 < f32(_e3053))));
let _e3059 = ((_e2226 * _e3040) + 0.5f);
let _e3061 = select(-1073741800f, _e3059, (_e3059 > -1073741800f));
let _e3063 = select(1073741800f, _e3061, (_e3061 < 1073741800f));
let _e3070 = select(0i, select(select(i32(_e3063), i32(-2147483648), (_e3063 < -2147483600f)), 2147483647i, (_e3063 > 2147483500f)), (_e3063 == _e3063));
let _e3076 = ((_e2227 * _e3040) + 0.5f);
let _e3078 = select(-1073741800f, _e3076, (_e3076 > -1073741800f));
let _e3080 = select(1073741800f, _e3078, (_e3078 < 1073741800f));
let _e3087 = select(0i, select(select(i32(_e3080), i32(-2147483648), (_e3080 < -2147483600f)), 2147483647i, (_e3080 > 2147483500f)), (_e3080 == _e3080));
let _e3091 = (_e3087 - select(0i, 1i, (_e3080 < f32(_e3087))));
let _e3093 = ((_e2228 * _e3040) + 0.5f);
let _e3095 = select(-1073741800f, _e3093, (_e3093 > -1073741800f));
let _e3097 = select(1073741800f, _e3095, (_e3095 < 1073741800f));
let _e3104 = select(0i, select(select(i32(_e3097), i32(-2147483648), (_e3097 < -2147483600f)), 2147483647i, (_e3097 > 2147483500f)), (_e3097 == _e3097));
let _e3108 = (_e3104 - select(0i, 1i, (_e3097 < f32(_e3104))));
let _e3110 = ((_e2229 * _e3040) + 0.5f);
let _e3112 = select(-1073741800f, _e3110, (_e3110 > -1073741800f));
let _e3114 = select(1073741800f, _e3112, (_e3112 < 1073741800f));
let _e3121 = select(0i, select(select(i32(_e3114), i32(-2147483648), (_e3114 < -2147483600f)), 2147483647i, (_e3114 > 2147483500f)), (_e3114 == _e3114));
let _e3126 = -(65536f);
let _e3128 = select(_e3126, _e2237, (_e2237 > _e3126));
let _e3130 = select(65536f, _e3128, (_e3128 < 65536f));
let _e3137 = select(0i, select(select(i32(_e3130), i32(-2147483648), (_e3130 < -2147483600f)), 2147483647i, (_e3130 > 2147483500f)), (_e3130 == _e3130));
let _e3144 = select(_e3126, _e2245, (_e2245 > _e3126));
let _e3146 = select(65536f, _e3144, (_e3144 < 65536f));
let _e3153 = select(0i, select(select(i32(_e3146), i32(-2147483648), (_e3146 < -2147483600f)), 2147483647i, (_e3146 > 2147483500f)), (_e3146 == _e3146));
phi_4477_ = ((_e3137 - select(0i, 1i, (_e3130 < f32(_e3137)))) + 1i);
loop {
let _e3159 = phi_4477_;
let _e3160 = (_e3159 <= (_e3153 - select(0i, 1i, (_e3146 < f32(_e3153)))));
if _e3160 {
let _e3161 = f32(_e3159);
let _e3165 = (_e886 + ((_e3161 - _e887) * (_e2250 / _e2251)));
let _e3166 = (_e887 <= _e3161);
let _e3167 = (_e883 <= _e3161);
let _e3168 = (_e3166 != _e3167);
let _e3171 = select(65536f, select(_e3165, 65536f, (65536f < _e3165)), _e3168);
let _e3174 = select(_e3126, select(_e3165, _e3126, (_e3126 > _e3165)), _e3168);
let _e3178 = (_e882 + ((_e3161 - _e883) * (_e906 / _e903)));
let _e3179 = (_e885 <= _e3161);
let _e3180 = (_e3167 != _e3179);
let _e3183 = select(_e3171, select(_e3178, _e3171, (_e3171 < _e3178)), _e3180);
let _e3186 = select(_e3174, select(_e3178, _e3174, (_e3174 > _e3178)), _e3180);
let _e3187 = (_e3161 - _e885);
let _e3192 = (_e884 + (_e3187 * ((_e884 - _e884) / (_e885 - _e885))));
let _e3193 = (_e3179 != _e3179);
let _e3196 = select(_e3183, select(_e3192, _e3183, (_e3183 < _e3192)), _e3193);
let _e3199 = select(_e3186, select(_e3192, _e3186, (_e3186 > _e3192)), _e3193);
let _e3204 = (_e884 + (_e3187 * ((_e886 - _e884) / (_e887 - _e885))));
let _e3205 = (_e3179 != _e3166);
let _e3212 = -(select(_e3196, select(_e3204, _e3196, (_e3196 < _e3204)), _e3205));
let _e3214 = select(_e3126, _e3212, (_e3212 > _e3126));
let _e3216 = select(65536f, _e3214, (_e3214 < 65536f));
let _e3223 = select(0i, select(select(i32(_e3216), i32(-2147483648), (_e3216 < -2147483600f)), 2147483647i, (_e3216 > 2147483500f)), (_e3216 == _e3216));
phi_4625_ = -((_e3223 - select(0i, 1i, (_e3216 < f32(_e3223)))));
loop {
let _e3230 = phi_4625_;
let _e3232 = (f32(_e3230) < select(_e3199, select(_e3204, _e3199, (_e3199 > _e3204)), _e3205));
if _e3232 {
if _e877 {
let _e3320 = global_1.member.member_12.member_17.member;
let _e3321 = bitcast<i32>(_e3320);
let _e3326 = global_1.member.member_12.member_17.member_1;
let _e3328 = (_e3230 + 1i);
let _e3329 = (_e3159 + 1i);
if ((((_e3328 >= 0i) && (_e3328 < _e3321)) && (_e3329 >= 0i)) && (_e3329 < bitcast<i32>(_e3326))) {
phi_4668_ = ((_e3329 * _e3321) + _e3328);
} else {
phi_4668_ = -1i;
}
let _e3340 = phi_4668_;
phi_4757_ = _e3340;
} else {
let _e3236 = global_1.member.member_12.member_15;
let _e3237 = bitcast<i32>(_e3236);
let _e3239 = (firstTrailingBit(8u) & 31u);
let _e3241 = (_e3230 >> bitcast<u32>(_e3239));
let _e3243 = (_e3159 >> bitcast<u32>(_e3239));
let _e3248 = global_1.member.member_12.member_14.member;
let _e3249 = bitcast<i32>(_e3248);
let _e3254 = global_1.member.member_12.member_14.member_1;
let _e3255 = bitcast<i32>(_e3254);
let _e3260 = global_1.member.member_12.member_14.member_2;
if ((((((_e3241 >= 0i) && (_e3241 < _e3249)) && (_e3243 >= 0i)) && (_e3243 < _e3255)) && (_e3237 >= 0i)) && (_e3237 < bitcast<i32>(_e3260))) {
phi_4712_ = (((((_e3237 * _e3255) + _e3243) * _e3249) + _e3241) * 3i);
} else {
phi_4712_ = -1i;
}
let _e3279 = phi_4712_;
let _e3280 = (_e3279 + 2i);
let _e3282 = (bitcast<i32>(_e61) - 1i);
let _e3284 = select(_e3282, _e3280, (_e3280 < _e3282));
let _e3289 = global_2.member[bitcast<u32>(select(0i, _e3284, (_e3284 > 0i)))];
let _e3290 = bitcast<i32>(_e3289);
if ((_e3279 < 0i) || (_e3290 == 0i)) {
phi_4756_ = -1i;
} else {
let _e3305 = global_1.member.member_12.member_17.member;
let _e3310 = global_1.member.member_12.member_17.member_1;
phi_4756_ = (bitcast<i32>((_e3305 * _e3310)) + ((((_e3290 - 1i) * 64i) + ((_e3159 & 7i) * 8i)) + (_e3230 & 7i)));
}
let _e3315 = phi_4756_;
phi_4757_ = _e3315;
}
let _e3342 = phi_4757_;
if (_e3342 >= 0i) {
let _e3344 = (_e3342 * 6i);
let _e3349 = (((_e80.member_2 == 3u) || (_e80.member_2 == 4u)) || (_e80.member_2 == 5u));
let _e3351 = bitcast<u32>(_e3057);
let _e3355 = bitcast<u32>((select((_e3070 - select(0i, 1i, (_e3063 < f32(_e3070)))), 0i, _e3349) + (_e3057 >> bitcast<u32>(31i))));
if ((_e3351 | _e3355) == 0u) {
} else {
let _e3358 = bitcast<u32>(_e3344);
if (_e3358 < _e64) {
let _e3361 = atomicAdd((&global_5.member[_e3358]), _e3351);
phi_4791_ = _e3361;
} else {
phi_4791_ = 0u;
}
let _e3363 = phi_4791_;
let _e3367 = (_e3355 + select(0u, 1u, ((_e3363 + _e3351) < _e3351)));
if (_e3367 == 0u) {
} else {
let _e3369 = (_e3358 + 1u);
if (_e3369 < _e64) {
let _e3372 = atomicAdd((&global_5.member[_e3369]), _e3367);
}
}
}
if _e3349 {
} else {
let _e3374 = bitcast<u32>(_e3091);
let _e3377 = bitcast<u32>((_e3091 >> bitcast<u32>(31i)));
if ((_e3374 | _e3377) == 0u) {
} else {
let _e3380 = bitcast<u32>((_e3344 + 4i));
if (_e3380 < _e64) {
let _e3383 = atomicAdd((&global_5.member[_e3380]), _e3374);
phi_4833_ = _e3383;
} else {
phi_4833_ = 0u;
}
let _e3385 = phi_4833_;
let _e3389 = (_e3377 + select(0u, 1u, ((_e3385 + _e3374) < _e3374)));
if (_e3389 == 0u) {
} else {
let _e3391 = (_e3380 + 1u);
if (_e3391 < _e64) {
let _e3394 = atomicAdd((&global_5.member[_e3391]), _e3389);
}
}
}
}
let _e3397 = global_1.member.member_22;
if (_e3397 > 0f) {
let _e3400 = bitcast<u32>(_e3108);
let _e3404 = bitcast<u32>(((_e3121 - select(0i, 1i, (_e3114 < f32(_e3121)))) + (_e3108 >> bitcast<u32>(31i))));
if ((_e3400 | _e3404) == 0u) {
} else {
let _e3407 = bitcast<u32>((_e3344 + 2i));
if (_e3407 < _e64) {
let _e3410 = atomicAdd((&global_5.member[_e3407]), _e3400);
phi_4873_ = _e3410;
} else {
phi_4873_ = 0u;
}
let _e3412 = phi_4873_;
let _e3416 = (_e3404 + select(0u, 1u, ((_e3412 + _e3400) < _e3400)));
if (_e3416 == 0u) {
} else {
let _e3418 = (_e3407 + 1u);
if (_e3418 < _e64) {
let _e3421 = atomicAdd((&global_5.member[_e3418]), _e3416);
}
}
}
}
}
phi_4626_ = (_e3230 + 1i);
} else {
phi_4626_ = i32();
}
let _e3424 = phi_4626_;
continue;
continuing {
phi_4625_ = _e3424;
break if !(_e3232);
}
}
phi_4478_ = (_e3159 + 1i);
} else {
phi_4478_ = i32();
}
let _e3428 = phi_4478_;
continue;
continuing {
phi_4477_ = _e3428;
break if !(_e3160);
}
}
} else {
if ((_e2259 && (_e2249 > 2f)) && _e2263) {
let _e2638 = (bitcast<f32>((bitcast<u32>(_e2250) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2251) & 2147483647u)));
let _e2645 = (bitcast<f32>((bitcast<u32>(_e909) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e912) & 2147483647u)));
let _e2646 = (_e2638 > _e2645);
let _e2648 = ((bitcast<f32>((bitcast<u32>(_e906) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e903) & 2147483647u))) > select(_e2645, _e2638, _e2646));
if _e2648 {
phi_4926_ = vec2<f32>(_e906, _e903);
} else {
if _e2646 {
phi_4925_ = vec2<f32>(_e2250, _e2251);
} else {
phi_4925_ = vec2<f32>(_e909, _e912);
}
let _e2652 = phi_4925_;
phi_4926_ = _e2652;
}
let _e2654 = phi_4926_;
if _e2648 {
phi_4936_ = vec2<f32>(_e882, _e883);
} else {
phi_4936_ = vec2<f32>(_e886, _e887);
}
let _e2658 = phi_4936_;
let _e2660 = select(1f, _e2249, (_e2249 > 1f));
let _e2662 = select(64f, _e2660, (_e2660 < 64f));
let _e2669 = select(0i, select(select(i32(_e2662), i32(-2147483648), (_e2662 < -2147483600f)), 2147483647i, (_e2662 > 2147483500f)), (_e2662 == _e2662));
let _e2674 = ((_e2669 - select(0i, 1i, (_e2662 < f32(_e2669)))) + 1i);
let _e2676 = (1f / f32(_e2674));
phi_4967_ = 0i;
loop {
let _e2678 = phi_4967_;
let _e2679 = (_e2678 < _e2674);
if _e2679 {
let _e2686 = ((f32(_e2678) + 0.5f) * _e2676);
let _e2689 = (_e2658.x + (_e2654.x * _e2686));
let _e2690 = (_e2658.y + (_e2654.y * _e2686));
let _e2691 = -(65536f);
let _e2693 = select(_e2691, _e2689, (_e2689 > _e2691));
let _e2695 = select(65536f, _e2693, (_e2693 < 65536f));
let _e2702 = select(0i, select(select(i32(_e2695), i32(-2147483648), (_e2695 < -2147483600f)), 2147483647i, (_e2695 > 2147483500f)), (_e2695 == _e2695));
let _e2706 = (_e2702 - select(0i, 1i, (_e2695 < f32(_e2702))));
let _e2708 = select(_e2691, _e2690, (_e2690 > _e2691));
let _e2710 = select(65536f, _e2708, (_e2708 < 65536f));
let _e2717 = select(0i, select(select(i32(_e2710), i32(-2147483648), (_e2710 < -2147483600f)), 2147483647i, (_e2710 > 2147483500f)), (_e2710 == _e2710));
let _e2721 = (_e2717 - select(0i, 1i, (_e2710 < f32(_e2717))));
let _e2723 = (_e2689 - f32(_e2706));
let _e2725 = (_e2690 - f32(_e2721));
phi_5050_ = 0i;
loop {
let _e2727 = phi_5050_;
let _e2728 = (_e2727 < 4i);
if _e2728 {
let _e2729 = (_e2727 & 1i);
let _e2731 = (_e2727 >> bitcast<u32>(1i));
if (_e2729 == 0i) {
phi_5065_ = (1f - _e2723);
} else {
phi_5065_ = _e2723;
}
let _e2735 = phi_5065_;
if (_e2731 == 0i) {
phi_5071_ = (1f - _e2725);
} else {
phi_5071_ = _e2725;
}
let _e2739 = phi_5071_;
let _e2747 = global_1.member.member_12.member_22;
let _e2748 = (_e2747 * (((_e2676 * _e2735) * _e2739) / (_e878 * _e878)));
let _e2750 = ((_e2225 * _e2748) + 0.5f);
let _e2752 = select(-1073741800f, _e2750, (_e2750 > -1073741800f));
let _e2754 = select(1073741800f, _e2752, (_e2752 < 1073741800f));
let _e2761 = select(0i, select(select(i32(_e2754), i32(-2147483648), (_e2754 < -2147483600f)), 2147483647i, (_e2754 > 2147483500f)), (_e2754 == _e2754));
let _e2765 = (_e2761 - select(0i, 1i, (_e2754 < f32(_e2761))));
let _e2767 = ((_e2226 * _e2748) + 0.5f);
let _e2769 = select(-1073741800f, _e2767, (_e2767 > -1073741800f));
let _e2771 = select(1073741800f, _e2769, (_e2769 < 1073741800f));
let _e2778 = select(0i, select(select(i32(_e2771), i32(-2147483648), (_e2771 < -2147483600f)), 2147483647i, (_e2771 > 2147483500f)), (_e2771 == _e2771));
let _e2784 = ((_e2227 * _e2748) + 0.5f);
let _e2786 = select(-1073741800f, _e2784, (_e2784 > -1073741800f));
let _e2788 = select(1073741800f, _e2786, (_e2786 < 1073741800f));
let _e2795 = select(0i, select(select(i32(_e2788), i32(-2147483648), (_e2788 < -2147483600f)), 2147483647i, (_e2788 > 2147483500f)), (_e2788 == _e2788));
let _e2799 = (_e2795 - select(0i, 1i, (_e2788 < f32(_e2795))));
let _e2801 = ((_e2228 * _e2748) + 0.5f);
let _e2803 = select(-1073741800f, _e2801, (_e2801 > -1073741800f));
let _e2805 = select(1073741800f, _e2803, (_e2803 < 1073741800f));
let _e2812 = select(0i, select(select(i32(_e2805), i32(-2147483648), (_e2805 < -2147483600f)), 2147483647i, (_e2805 > 2147483500f)), (_e2805 == _e2805));
let _e2816 = (_e2812 - select(0i, 1i, (_e2805 < f32(_e2812))));
let _e2818 = ((_e2229 * _e2748) + 0.5f);
let _e2820 = select(-1073741800f, _e2818, (_e2818 > -1073741800f));
let _e2822 = select(1073741800f, _e2820, (_e2820 < 1073741800f));
let _e2829 = select(0i, select(select(i32(_e2822), i32(-2147483648), (_e2822 < -2147483600f)), 2147483647i, (_e2822 > 2147483500f)), (_e2822 == _e2822));
let _e2834 = (_e2706 + _e2729);
let _e2835 = (_e2721 + _e2731);
if _e877 {
let _e2923 = global_1.member.member_12.member_17.member;
let _e2924 = bitcast<i32>(_e2923);
let _e2929 = global_1.member.member_12.member_17.member_1;
let _e2931 = (_e2834 + 1i);
let _e2932 = (_e2835 + 1i);
if ((((_e2931 >= 0i) && (_e2931 < _e2924)) && (_e2932 >= 0i)) && (_e2932 < bitcast<i32>(_e2929))) {
phi_5246_ = ((_e2932 * _e2924) + _e2931);
} else {
phi_5246_ = -1i;
}
let _e2943 = phi_5246_;
phi_5335_ = _e2943;
} else {
let _e2839 = global_1.member.member_12.member_15;
let _e2840 = bitcast<i32>(_e2839);
let _e2842 = (firstTrailingBit(8u) & 31u);
let _e2844 = (_e2834 >> bitcast<u32>(_e2842));
let _e2846 = (_e2835 >> bitcast<u32>(_e2842));
let _e2851 = global_1.member.member_12.member_14.member;
let _e2852 = bitcast<i32>(_e2851);
let _e2857 = global_1.member.member_12.member_14.member_1;
let _e2858 = bitcast<i32>(_e2857);
let _e2863 = global_1.member.member_12.member_14.member_2;
if ((((((_e2844 >= 0i) && (_e2844 < _e2852)) && (_e2846 >= 0i)) && (_e2846 < _e2858)) && (_e2840 >= 0i)) && (_e2840 < bitcast<i32>(_e2863))) {
phi_5290_ = (((((_e2840 * _e2858) + _e2846) * _e2852) + _e2844) * 3i);
} else {
phi_5290_ = -1i;
}
let _e2882 = phi_5290_;
let _e2883 = (_e2882 + 2i);
let _e2885 = (bitcast<i32>(_e61) - 1i);
let _e2887 = select(_e2885, _e2883, (_e2883 < _e2885));
let _e2892 = global_2.member[bitcast<u32>(select(0i, _e2887, (_e2887 > 0i)))];
let _e2893 = bitcast<i32>(_e2892);
if ((_e2882 < 0i) || (_e2893 == 0i)) {
phi_5334_ = -1i;
} else {
let _e2908 = global_1.member.member_12.member_17.member;
let _e2913 = global_1.member.member_12.member_17.member_1;
phi_5334_ = (bitcast<i32>((_e2908 * _e2913)) + ((((_e2893 - 1i) * 64i) + ((_e2835 & 7i) * 8i)) + (_e2834 & 7i)));
}
let _e2918 = phi_5334_;
phi_5335_ = _e2918;
}
let _e2945 = phi_5335_;
if (_e2945 >= 0i) {
let _e2947 = (_e2945 * 6i);
let _e2952 = (((_e80.member_2 == 3u) || (_e80.member_2 == 4u)) || (_e80.member_2 == 5u));
let _e2954 = bitcast<u32>(_e2765);
let _e2958 = bitcast<u32>((select((_e2778 - select(0i, 1i, (_e2771 < f32(_e2778)))), 0i, _e2952) + (_e2765 >> bitcast<u32>(31i))));
if ((_e2954 | _e2958) == 0u) {
} else {
let _e2961 = bitcast<u32>(_e2947);
if (_e2961 < _e64) {
let _e2964 = atomicAdd((&global_5.member[_e2961]), _e2954);
phi_5369_ = _e2964;
} else {
phi_5369_ = 0u;
}
let _e2966 = phi_5369_;
let _e2970 = (_e2958 + select(0u, 1u, ((_e2966 + _e2954) < _e2954)));
if (_e2970 == 0u) {
} else {
let _e2972 = (_e2961 + 1u);
if (_e2972 < _e64) {
let _e2975 = atomicAdd((&global_5.member[_e2972]), _e2970);
}
}
}
if _e2952 {
} else {
let _e2977 = bitcast<u32>(_e2799);
let _e2980 = bitcast<u32>((_e2799 >> bitcast<u32>(31i)));
if ((_e2977 | _e2980) == 0u) {
} else {
let _e2983 = bitcast<u32>((_e2947 + 4i));
if (_e2983 < _e64) {
let _e2986 = atomicAdd((&global_5.member[_e2983]), _e2977);
phi_5411_ = _e2986;
} else {
phi_5411_ = 0u;
}
let _e2988 = phi_5411_;
let _e2992 = (_e2980 + select(0u, 1u, ((_e2988 + _e2977) < _e2977)));
if (_e2992 == 0u) {
} else {
let _e2994 = (_e2983 + 1u);
if (_e2994 < _e64) {
let _e2997 = atomicAdd((&global_5.member[_e2994]), _e2992);
}
}
}
}
let _e3000 = global_1.member.member_22;
if (_e3000 > 0f) {
let _e3003 = bitcast<u32>(_e2816);
let _e3007 = bitcast<u32>(((_e2829 - select(0i, 1i, (_e2822 < f32(_e2829)))) + (_e2816 >> bitcast<u32>(31i))));
if ((_e3003 | _e3007) == 0u) {
} else {
let _e3010 = bitcast<u32>((_e2947 + 2i));
if (_e3010 < _e64) {
let _e3013 = atomicAdd((&global_5.member[_e3010]), _e3003);
phi_5451_ = _e3013;
} else {
phi_5451_ = 0u;
}
let _e3015 = phi_5451_;
let _e3019 = (_e3007 + select(0u, 1u, ((_e3015 + _e3003) < _e3003)));
if (_e3019 == 0u) {
} else {
let _e3021 = (_e3010 + 1u);
if (_e3021 < _e64) {
let _e3024 = atomicAdd((&global_5.member[_e3021]), _e3019);
}
}
}
}
}
phi_5051_ = (_e2727 + 1i);
} else {
phi_5051_ = i32();
}
let _e3027 = phi_5051_;
continue;
continuing {
phi_5050_ = _e3027;
break if !(_e2728);
}
}
phi_4968_ = (_e2678 + 1i);
} else {
phi_4968_ = i32();
}
let _e3031 = phi_4968_;
continue;
continuing {
phi_4967_ = _e3031;
break if !(_e2679);
}
}
} else {
if ((_e2204 > 0f) && (!(_e2259) || (_e2249 <= 2f))) {
let _e2283 = (1f / _e2204);
let _e2284 = ((((_e886 * _e2202) + (_e882 * _e952)) + (_e884 * _e953)) * _e2283);
let _e2285 = ((((_e887 * _e2202) + (_e883 * _e952)) + (_e885 * _e953)) * _e2283);
let _e2286 = -(65536f);
let _e2288 = select(_e2286, _e2284, (_e2284 > _e2286));
let _e2290 = select(65536f, _e2288, (_e2288 < 65536f));
let _e2297 = select(0i, select(select(i32(_e2290), i32(-2147483648), (_e2290 < -2147483600f)), 2147483647i, (_e2290 > 2147483500f)), (_e2290 == _e2290));
let _e2301 = (_e2297 - select(0i, 1i, (_e2290 < f32(_e2297))));
let _e2303 = select(_e2286, _e2285, (_e2285 > _e2286));
let _e2305 = select(65536f, _e2303, (_e2303 < 65536f));
let _e2312 = select(0i, select(select(i32(_e2305), i32(-2147483648), (_e2305 < -2147483600f)), 2147483647i, (_e2305 > 2147483500f)), (_e2305 == _e2305));
let _e2316 = (_e2312 - select(0i, 1i, (_e2305 < f32(_e2312))));
let _e2318 = (_e2284 - f32(_e2301));
let _e2320 = (_e2285 - f32(_e2316));
phi_5560_ = 0i;
loop {
let _e2322 = phi_5560_;
let _e2323 = (_e2322 < 4i);
if _e2323 {
let _e2324 = (_e2322 & 1i);
let _e2326 = (_e2322 >> bitcast<u32>(1i));
if (_e2324 == 0i) {
phi_5575_ = (1f - _e2318);
} else {
phi_5575_ = _e2318;
}
let _e2330 = phi_5575_;
if (_e2326 == 0i) {
phi_5581_ = (1f - _e2320);
} else {
phi_5581_ = _e2320;
}
let _e2334 = phi_5581_;
let _e2342 = global_1.member.member_12.member_22;
let _e2343 = (_e2342 * (((1f * _e2330) * _e2334) / (_e878 * _e878)));
let _e2345 = ((_e2225 * _e2343) + 0.5f);
let _e2347 = select(-1073741800f, _e2345, (_e2345 > -1073741800f));
let _e2349 = select(1073741800f, _e2347, (_e2347 < 1073741800f));
let _e2356 = select(0i, select(select(i32(_e2349), i32(-2147483648), (_e2349 < -2147483600f)), 2147483647i, (_e2349 > 2147483500f)), (_e2349 == _e2349));
let _e2360 = (_e2356 - select(0i, 1i, (_e2349 < f32(_e2356))));
let _e2362 = ((_e2226 * _e2343) + 0.5f);
let _e2364 = select(-1073741800f, _e2362, (_e2362 > -1073741800f));
let _e2366 = select(1073741800f, _e2364, (_e2364 < 1073741800f));
let _e2373 = select(0i, select(select(i32(_e2366), i32(-2147483648), (_e2366 < -2147483600f)), 2147483647i, (_e2366 > 2147483500f)), (_e2366 == _e2366));
let _e2379 = ((_e2227 * _e2343) + 0.5f);
let _e2381 = select(-1073741800f, _e2379, (_e2379 > -1073741800f));
let _e2383 = select(1073741800f, _e2381, (_e2381 < 1073741800f));
let _e2390 = select(0i, select(select(i32(_e2383), i32(-2147483648), (_e2383 < -2147483600f)), 2147483647i, (_e2383 > 2147483500f)), (_e2383 == _e2383));
let _e2394 = (_e2390 - select(0i, 1i, (_e2383 < f32(_e2390))));
let _e2396 = ((_e2228 * _e2343) + 0.5f);
let _e2398 = select(-1073741800f, _e2396, (_e2396 > -1073741800f));
let _e2400 = select(1073741800f, _e2398, (_e2398 < 1073741800f));
let _e2407 = select(0i, select(select(i32(_e2400), i32(-2147483648), (_e2400 < -2147483600f)), 2147483647i, (_e2400 > 2147483500f)), (_e2400 == _e2400));
let _e2411 = (_e2407 - select(0i, 1i, (_e2400 < f32(_e2407))));
let _e2413 = ((_e2229 * _e2343) + 0.5f);
let _e2415 = select(-1073741800f, _e2413, (_e2413 > -1073741800f));
let _e2417 = select(1073741800f, _e2415, (_e2415 < 1073741800f));
let _e2424 = select(0i, select(select(i32(_e2417), i32(-2147483648), (_e2417 < -2147483600f)), 2147483647i, (_e2417 > 2147483500f)), (_e2417 == _e2417));
let _e2429 = (_e2301 + _e2324);
let _e2430 = (_e2316 + _e2326);
if _e877 {
let _e2518 = global_1.member.member_12.member_17.member;
let _e2519 = bitcast<i32>(_e2518);
let _e2524 = global_1.member.member_12.member_17.member_1;
let _e2526 = (_e2429 + 1i);
let _e2527 = (_e2430 + 1i);
if ((((_e2526 >= 0i) && (_e2526 < _e2519)) && (_e2527 >= 0i)) && (_e2527 < bitcast<i32>(_e2524))) {
phi_5756_ = ((_e2527 * _e2519) + _e2526);
} else {
phi_5756_ = -1i;
}
let _e2538 = phi_5756_;
phi_5845_ = _e2538;
} else {
let _e2434 = global_1.member.member_12.member_15;
let _e2435 = bitcast<i32>(_e2434);
let _e2437 = (firstTrailingBit(8u) & 31u);
let _e2439 = (_e2429 >> bitcast<u32>(_e2437));
let _e2441 = (_e2430 >> bitcast<u32>(_e2437));
let _e2446 = global_1.member.member_12.member_14.member;
let _e2447 = bitcast<i32>(_e2446);
let _e2452 = global_1.member.member_12.member_14.member_1;
let _e2453 = bitcast<i32>(_e2452);
let _e2458 = global_1.member.member_12.member_14.member_2;
if ((((((_e2439 >= 0i) && (_e2439 < _e2447)) && (_e2441 >= 0i)) && (_e2441 < _e2453)) && (_e2435 >= 0i)) && (_e2435 < bitcast<i32>(_e2458))) {
phi_5800_ = (((((_e2435 * _e2453) + _e2441) * _e2447) + _e2439) * 3i);
} else {
phi_5800_ = -1i;
}
let _e2477 = phi_5800_;
let _e2478 = (_e2477 + 2i);
let _e2480 = (bitcast<i32>(_e61) - 1i);
let _e2482 = select(_e2480, _e2478, (_e2478 < _e2480));
let _e2487 = global_2.member[bitcast<u32>(select(0i, _e2482, (_e2482 > 0i)))];
let _e2488 = bitcast<i32>(_e2487);
if ((_e2477 < 0i) || (_e2488 == 0i)) {
phi_5844_ = -1i;
} else {
let _e2503 = global_1.member.member_12.member_17.member;
let _e2508 = global_1.member.member_12.member_17.member_1;
phi_5844_ = (bitcast<i32>((_e2503 * _e2508)) + ((((_e2488 - 1i) * 64i) + ((_e2430 & 7i) * 8i)) + (_e2429 & 7i)));
}
let _e2513 = phi_5844_;
phi_5845_ = _e2513;
}
let _e2540 = phi_5845_;
if (_e2540 >= 0i) {
let _e2542 = (_e2540 * 6i);
let _e2547 = (((_e80.member_2 == 3u) || (_e80.member_2 == 4u)) || (_e80.member_2 == 5u));
let _e2549 = bitcast<u32>(_e2360);
let _e2553 = bitcast<u32>((select((_e2373 - select(0i, 1i, (_e2366 < f32(_e2373)))), 0i, _e2547) + (_e2360 >> bitcast<u32>(31i))));
if ((_e2549 | _e2553) == 0u) {
} else {
let _e2556 = bitcast<u32>(_e2542);
if (_e2556 < _e64) {
let _e2559 = atomicAdd((&global_5.member[_e2556]), _e2549);
phi_5879_ = _e2559;
} else {
phi_5879_ = 0u;
}
let _e2561 = phi_5879_;
let _e2565 = (_e2553 + select(0u, 1u, ((_e2561 + _e2549) < _e2549)));
if (_e2565 == 0u) {
} else {
let _e2567 = (_e2556 + 1u);
if (_e2567 < _e64) {
let _e2570 = atomicAdd((&global_5.member[_e2567]), _e2565);
}
}
}
if _e2547 {
} else {
let _e2572 = bitcast<u32>(_e2394);
let _e2575 = bitcast<u32>((_e2394 >> bitcast<u32>(31i)));
if ((_e2572 | _e2575) == 0u) {
} else {
let _e2578 = bitcast<u32>((_e2542 + 4i));
if (_e2578 < _e64) {
let _e2581 = atomicAdd((&global_5.member[_e2578]), _e2572);
phi_5921_ = _e2581;
} else {
phi_5921_ = 0u;
}
let _e2583 = phi_5921_;
let _e2587 = (_e2575 + select(0u, 1u, ((_e2583 + _e2572) < _e2572)));
if (_e2587 == 0u) {
} else {
let _e2589 = (_e2578 + 1u);
if (_e2589 < _e64) {
let _e2592 = atomicAdd((&global_5.member[_e2589]), _e2587);
}
}
}
}
let _e2595 = global_1.member.member_22;
if (_e2595 > 0f) {
let _e2598 = bitcast<u32>(_e2411);
let _e2602 = bitcast<u32>(((_e2424 - select(0i, 1i, (_e2417 < f32(_e2424)))) + (_e2411 >> bitcast<u32>(31i))));
if ((_e2598 | _e2602) == 0u) {
} else {
let _e2605 = bitcast<u32>((_e2542 + 2i));
if (_e2605 < _e64) {
let _e2608 = atomicAdd((&global_5.member[_e2605]), _e2598);
phi_5961_ = _e2608;
} else {
phi_5961_ = 0u;
}
let _e2610 = phi_5961_;
let _e2614 = (_e2602 + select(0u, 1u, ((_e2610 + _e2598) < _e2598)));
if (_e2614 == 0u) {
} else {
let _e2616 = (_e2605 + 1u);
if (_e2616 < _e64) {
let _e2619 = atomicAdd((&global_5.member[_e2616]), _e2614);
}
}
}
}
}
phi_5561_ = (_e2322 + 1i);
} else {
phi_5561_ = i32();
}
let _e2622 = phi_5561_;
continue;
continuing {
phi_5560_ = _e2622;
break if !(_e2323);
}
}
}
}
}
}
} else {
if ((_e106 != 0f) && (_e106 < 16f)) {
let _e112 = ((3i * _e93) + _e96);
let _e114 = select(_e98, _e112, (_e112 < _e98));
let _e120 = global_3.member[bitcast<u32>(select(0i, _e114, (_e114 > 0i)))];
let _e122 = select(-1073741800f, _e120, (_e120 > -1073741800f));
let _e124 = select(1073741800f, _e122, (_e122 < 1073741800f));
let _e131 = select(0i, select(select(i32(_e124), i32(-2147483648), (_e124 < -2147483600f)), 2147483647i, (_e124 > 2147483500f)), (_e124 == _e124));
let _e135 = (_e131 - select(0i, 1i, (_e124 < f32(_e131))));
let _e137 = ((4i * _e93) + _e96);
let _e139 = select(_e98, _e137, (_e137 < _e98));
let _e145 = global_3.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e147 = select(-1073741800f, _e145, (_e145 > -1073741800f));
let _e149 = select(1073741800f, _e147, (_e147 < 1073741800f));
let _e156 = select(0i, select(select(i32(_e149), i32(-2147483648), (_e149 < -2147483600f)), 2147483647i, (_e149 > 2147483500f)), (_e149 == _e149));
let _e162 = ((5i * _e93) + _e96);
let _e164 = select(_e98, _e162, (_e162 < _e98));
let _e170 = global_3.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e172 = select(-1073741800f, _e170, (_e170 > -1073741800f));
let _e174 = select(1073741800f, _e172, (_e172 < 1073741800f));
let _e181 = select(0i, select(select(i32(_e174), i32(-2147483648), (_e174 < -2147483600f)), 2147483647i, (_e174 > 2147483500f)), (_e174 == _e174));
let _e185 = (_e181 - select(0i, 1i, (_e174 < f32(_e181))));
let _e187 = ((6i * _e93) + _e96);
let _e189 = select(_e98, _e187, (_e187 < _e98));
let _e195 = global_3.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = select(-1073741800f, _e195, (_e195 > -1073741800f));
let _e199 = select(1073741800f, _e197, (_e197 < 1073741800f));
let _e206 = select(0i, select(select(i32(_e199), i32(-2147483648), (_e199 < -2147483600f)), 2147483647i, (_e199 > 2147483500f)), (_e199 == _e199));
let _e210 = (_e206 - select(0i, 1i, (_e199 < f32(_e206))));
let _e212 = ((7i * _e93) + _e96);
let _e214 = select(_e98, _e212, (_e212 < _e98));
let _e220 = global_3.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = select(-1073741800f, _e220, (_e220 > -1073741800f));
let _e224 = select(1073741800f, _e222, (_e222 < 1073741800f));
let _e231 = select(0i, select(select(i32(_e224), i32(-2147483648), (_e224 < -2147483600f)), 2147483647i, (_e224 > 2147483500f)), (_e224 == _e224));
let _e236 = (_e93 + _e96);
let _e238 = select(_e98, _e236, (_e236 < _e98));
let _e244 = global_3.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e246 = select(-1073741800f, _e244, (_e244 > -1073741800f));
let _e248 = select(1073741800f, _e246, (_e246 < 1073741800f));
let _e255 = select(0i, select(select(i32(_e248), i32(-2147483648), (_e248 < -2147483600f)), 2147483647i, (_e248 > 2147483500f)), (_e248 == _e248));
let _e261 = ((2i * _e93) + _e96);
let _e263 = select(_e98, _e261, (_e261 < _e98));
let _e269 = global_3.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e271 = select(-1073741800f, _e269, (_e269 > -1073741800f));
let _e273 = select(1073741800f, _e271, (_e271 < 1073741800f));
let _e280 = select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < -2147483600f)), 2147483647i, (_e273 > 2147483500f)), (_e273 == _e273));
let _e286 = select(0f, _e106, (_e106 > 0f));
let _e288 = select(15f, _e286, (_e286 < 15f));
let _e295 = select(0i, select(select(i32(_e288), i32(-2147483648), (_e288 < -2147483600f)), 2147483647i, (_e288 > 2147483500f)), (_e288 == _e288));
phi_6298_ = 0i;
loop {
let _e301 = phi_6298_;
let _e302 = (_e301 < 4i);
if _e302 {
if ((((_e295 - select(0i, 1i, (_e288 < f32(_e295)))) >> bitcast<u32>((_e301 & 31i))) & 1i) == 0i) {
} else {
let _e309 = ((_e255 - select(0i, 1i, (_e248 < f32(_e255)))) + (_e301 & 1i));
let _e312 = ((_e280 - select(0i, 1i, (_e273 < f32(_e280)))) + (_e301 >> bitcast<u32>(1i)));
let _e316 = global_1.member.member_12.member_15;
let _e317 = bitcast<i32>(_e316);
let _e319 = (firstTrailingBit(8u) & 31u);
let _e321 = (_e309 >> bitcast<u32>(_e319));
let _e323 = (_e312 >> bitcast<u32>(_e319));
let _e328 = global_1.member.member_12.member_14.member;
let _e329 = bitcast<i32>(_e328);
let _e334 = global_1.member.member_12.member_14.member_1;
let _e335 = bitcast<i32>(_e334);
let _e340 = global_1.member.member_12.member_14.member_2;
if ((((((_e321 >= 0i) && (_e321 < _e329)) && (_e323 >= 0i)) && (_e323 < _e335)) && (_e317 >= 0i)) && (_e317 < bitcast<i32>(_e340))) {
phi_6395_ = (((((_e317 * _e335) + _e323) * _e329) + _e321) * 3i);
} else {
phi_6395_ = -1i;
}
let _e359 = phi_6395_;
let _e360 = (_e359 + 2i);
let _e362 = (bitcast<i32>(_e61) - 1i);
let _e364 = select(_e362, _e360, (_e360 < _e362));
let _e369 = global_2.member[bitcast<u32>(select(0i, _e364, (_e364 > 0i)))];
let _e370 = bitcast<i32>(_e369);
if ((_e359 < 0i) || (_e370 == 0i)) {
phi_6439_ = -1i;
} else {
let _e385 = global_1.member.member_12.member_17.member;
let _e390 = global_1.member.member_12.member_17.member_1;
phi_6439_ = (bitcast<i32>((_e385 * _e390)) + ((((_e370 - 1i) * 64i) + ((_e312 & 7i) * 8i)) + (_e309 & 7i)));
}
let _e395 = phi_6439_;
if (_e395 >= 0i) {
let _e397 = (_e395 * 6i);
let _e402 = (((_e80.member_2 == 3u) || (_e80.member_2 == 4u)) || (_e80.member_2 == 5u));
let _e404 = bitcast<u32>(_e135);
let _e408 = bitcast<u32>((select((_e156 - select(0i, 1i, (_e149 < f32(_e156)))), 0i, _e402) + (_e135 >> bitcast<u32>(31i))));
if ((_e404 | _e408) == 0u) {
} else {
let _e411 = bitcast<u32>(_e397);
if (_e411 < _e64) {
let _e414 = atomicAdd((&global_5.member[_e411]), _e404);
phi_6474_ = _e414;
} else {
phi_6474_ = 0u;
}
let _e416 = phi_6474_;
let _e420 = (_e408 + select(0u, 1u, ((_e416 + _e404) < _e404)));
if (_e420 == 0u) {
} else {
let _e422 = (_e411 + 1u);
if (_e422 < _e64) {
let _e425 = atomicAdd((&global_5.member[_e422]), _e420);
}
}
}
if _e402 {
} else {
let _e427 = bitcast<u32>(_e185);
let _e430 = bitcast<u32>((_e185 >> bitcast<u32>(31i)));
if ((_e427 | _e430) == 0u) {
} else {
let _e433 = bitcast<u32>((_e397 + 4i));
if (_e433 < _e64) {
let _e436 = atomicAdd((&global_5.member[_e433]), _e427);
phi_6516_ = _e436;
} else {
phi_6516_ = 0u;
}
let _e438 = phi_6516_;
let _e442 = (_e430 + select(0u, 1u, ((_e438 + _e427) < _e427)));
if (_e442 == 0u) {
} else {
let _e444 = (_e433 + 1u);
if (_e444 < _e64) {
let _e447 = atomicAdd((&global_5.member[_e444]), _e442);
}
}
}
}
let _e450 = global_1.member.member_22;
if (_e450 > 0f) {
let _e453 = bitcast<u32>(_e210);
let _e457 = bitcast<u32>(((_e231 - select(0i, 1i, (_e224 < f32(_e231)))) + (_e210 >> bitcast<u32>(31i))));
if ((_e453 | _e457) == 0u) {
} else {
let _e460 = bitcast<u32>((_e397 + 2i));
if (_e460 < _e64) {
let _e463 = atomicAdd((&global_5.member[_e460]), _e453);
phi_6556_ = _e463;
} else {
phi_6556_ = 0u;
}
let _e465 = phi_6556_;
let _e469 = (_e457 + select(0u, 1u, ((_e465 + _e453) < _e453)));
if (_e469 == 0u) {
} else {
let _e471 = (_e460 + 1u);
if (_e471 < _e64) {
let _e474 = atomicAdd((&global_5.member[_e471]), _e469);
}
}
}
}
}
}
phi_6299_ = (_e301 + 1i);
} else {
phi_6299_ = i32();
}
let _e477 = phi_6299_;
continue;
continuing {
phi_6298_ = _e477;
break if !(_e302);
}
}
}
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
