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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_3830_: type_29;
var phi_4532_: type_30;
var phi_5457_: type_5;
var phi_6481_: f32;
var phi_6482_: f32;
var phi_6483_: f32;
var phi_6484_: bool;
switch bitcast<i32>(0u) {
default: {
let _e90 = global;
let _e93 = arrayLength((&global_2.member));
let _e97 = arrayLength((&global_4.member));
let _e104 = global_1.member.member_2;
let _e107 = global_1.member.member;
let _e115 = (_e90.x + _e104.member);
let _e117 = (_e90.y + _e104.member_1);
if (_e115 < _e104.member_2) {
if (_e117 < _e104.member_3) {
let _e120 = (_e107.member * _e107.member_1);
let _e122 = ((_e117 * _e107.member) + _e115);
let _e123 = bitcast<i32>(_e122);
let _e125 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e127 = select(_e125, _e123, (_e123 < _e125));
let _e133 = global_6.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e134 = (_e120 + _e122);
let _e135 = bitcast<i32>(_e134);
let _e137 = select(_e125, _e135, (_e135 < _e125));
let _e143 = global_6.member[bitcast<u32>(select(0i, _e137, (_e137 > 0i)))];
let _e145 = ((2u * _e120) + _e122);
let _e146 = bitcast<i32>(_e145);
let _e148 = select(_e125, _e146, (_e146 < _e125));
let _e154 = global_6.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e156 = ((3u * _e120) + _e122);
let _e157 = bitcast<i32>(_e156);
let _e159 = select(_e125, _e157, (_e157 < _e125));
let _e165 = global_6.member[bitcast<u32>(select(0i, _e159, (_e159 > 0i)))];
let _e167 = ((4u * _e120) + _e122);
let _e168 = bitcast<i32>(_e167);
let _e170 = select(_e125, _e168, (_e168 < _e125));
let _e176 = global_6.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
let _e178 = ((5u * _e120) + _e122);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e125, _e179, (_e179 < _e125));
let _e187 = global_6.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((6u * _e120) + _e122);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e125, _e190, (_e190 < _e125));
let _e198 = global_6.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((7u * _e120) + _e122);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e125, _e201, (_e201 < _e125));
let _e209 = global_6.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((8u * _e120) + _e122);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e125, _e212, (_e212 < _e125));
let _e220 = global_6.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e222 = ((9u * _e120) + _e122);
let _e223 = bitcast<i32>(_e222);
let _e225 = select(_e125, _e223, (_e223 < _e125));
let _e231 = global_6.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e233 = ((10u * _e120) + _e122);
let _e234 = bitcast<i32>(_e233);
let _e236 = select(_e125, _e234, (_e234 < _e125));
let _e242 = global_6.member[bitcast<u32>(select(0i, _e236, (_e236 > 0i)))];
let _e246 = global_1.member.member_5.member_2;
let _e249 = (1f / select(1e-6f, _e198, (_e198 > 1e-6f)));
let _e253 = global_1.member.member_8.member_5;
let _e254 = (_e246 * _e253);
let _e259 = global_1.member.member_8.member_6;
let _e261 = (((_e176 * _e249) - _e259) * _e254);
let _e266 = global_1.member.member_8.member_7;
let _e268 = (((_e187 * _e249) - _e266) * _e254);
let _e272 = ((f32(bitcast<i32>(_e115)) - 0.5f) + _e133);
let _e276 = global_1.member.member_8.member_1;
let _e277 = (_e276 + 1u);
let _e279 = select(1u, _e277, (_e277 > 0u));
let _e280 = (_e279 == 0u);
if _e280 {
break;
}
let _e285 = ((f32(bitcast<i32>((_e117 % _e279))) - 0.5f) + _e143);
let _e289 = global_1.member.member_5.member;
let _e293 = global_1.member.member_8.member_8;
let _e294 = (_e289 - _e293);
let _e298 = global_1.member.member_8.member_2;
let _e305 = global_1.member.member_8.member_4;
let _e307 = ((_e298 + (_e259 * _e294)) + ((_e272 + 0.5f) * _e305));
let _e311 = global_1.member.member_8.member_3;
let _e316 = ((_e311 + (_e266 * _e294)) + ((_e285 + 0.5f) * _e305));
let _e322 = global_1.member.member_5.member_1;
let _e323 = (_e322 - _e293);
let _e328 = ((_e298 + (_e259 * _e323)) + (((_e272 + _e261) + 0.5f) * _e305));
let _e333 = ((_e311 + (_e266 * _e323)) + (((_e285 + _e268) + 0.5f) * _e305));
if _e280 {
break;
}
let _e336 = bitcast<i32>(((_e117 / _e279) * 3u));
let _e338 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e340 = select(_e338, _e336, (_e336 < _e338));
let _e346 = global_5.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e347 = (_e336 + 1i);
let _e349 = select(_e338, _e347, (_e347 < _e338));
let _e355 = global_5.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e356 = (_e336 + 2i);
let _e358 = select(_e338, _e356, (_e356 < _e338));
let _e364 = global_5.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e367 = (1f / select(1e-6f, _e364, (_e364 > 1e-6f)));
let _e370 = (((_e346 * _e367) - _e259) * _e254);
let _e373 = (((_e355 * _e367) - _e266) * _e254);
let _e385 = global_1.member.member_6.member;
let _e396 = ((((_e385.member.member * _e307) + (_e385.member.member_1 * _e316)) + (_e385.member.member_2 * _e289)) + _e385.member_1);
let _e400 = global_1.member.member_6.member_1;
let _e411 = ((((_e400.member.member * _e307) + (_e400.member.member_1 * _e316)) + (_e400.member.member_2 * _e289)) + _e400.member_1);
let _e415 = global_1.member.member_6.member_2;
let _e426 = ((((_e415.member.member * _e307) + (_e415.member.member_1 * _e316)) + (_e415.member.member_2 * _e289)) + _e415.member_1);
let _e432 = ((((_e385.member.member * _e328) + (_e385.member.member_1 * _e333)) + (_e385.member.member_2 * _e322)) + _e385.member_1);
let _e438 = ((((_e400.member.member * _e328) + (_e400.member.member_1 * _e333)) + (_e400.member.member_2 * _e322)) + _e400.member_1);
let _e444 = ((((_e415.member.member * _e328) + (_e415.member.member_1 * _e333)) + (_e415.member.member_2 * _e322)) + _e415.member_1);
let _e448 = global_1.member.member_6.member_4;
let _e453 = global_1.member.member_6.member_3.member;
let _e454 = (_e453 - 0.5f);
let _e456 = select(-0.5f, _e432, (_e432 > -0.5f));
let _e458 = select(_e454, _e456, (_e456 < _e454));
let _e463 = global_1.member.member_6.member_3.member_1;
let _e464 = (_e463 - 0.5f);
let _e466 = select(-0.5f, _e438, (_e438 > -0.5f));
let _e468 = select(_e464, _e466, (_e466 < _e464));
let _e473 = global_1.member.member_6.member_3.member_2;
let _e474 = (_e473 - 0.5f);
let _e476 = select(-0.5f, _e444, (_e444 > -0.5f));
let _e478 = select(_e474, _e476, (_e476 < _e474));
let _e479 = (_e432 - _e396);
let _e480 = (_e438 - _e411);
let _e481 = (_e444 - _e426);
let _e484 = bitcast<f32>((bitcast<u32>(_e479) & 2147483647u));
let _e487 = bitcast<f32>((bitcast<u32>(_e480) & 2147483647u));
let _e489 = select(_e487, _e484, (_e484 > _e487));
let _e492 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
let _e501 = bitcast<f32>((bitcast<u32>((_e432 - _e458)) & 2147483647u));
let _e504 = bitcast<f32>((bitcast<u32>((_e438 - _e468)) & 2147483647u));
let _e506 = select(_e504, _e501, (_e501 > _e504));
let _e509 = bitcast<f32>((bitcast<u32>((_e444 - _e478)) & 2147483647u));
let _e513 = (_e458 + 0.5f);
let _e514 = (_e453 - 1f);
let _e516 = select(0f, _e513, (_e513 > 0f));
let _e518 = select(_e514, _e516, (_e516 < _e514));
let _e525 = select(0i, select(select(i32(_e518), i32(-2147483648), (_e518 < -2147483600f)), 2147483647i, (_e518 > 2147483500f)), (_e518 == _e518));
let _e533 = global_1.member.member_6.member_12;
let _e534 = (_e533 & 31u);
let _e537 = (_e468 + 0.5f);
let _e538 = (_e463 - 1f);
let _e540 = select(0f, _e537, (_e537 > 0f));
let _e542 = select(_e538, _e540, (_e540 < _e538));
let _e549 = select(0i, select(select(i32(_e542), i32(-2147483648), (_e542 < -2147483600f)), 2147483647i, (_e542 > 2147483500f)), (_e542 == _e542));
let _e556 = (_e478 + 0.5f);
let _e557 = (_e473 - 1f);
let _e559 = select(0f, _e556, (_e556 > 0f));
let _e561 = select(_e557, _e559, (_e559 < _e557));
let _e568 = select(0i, select(select(i32(_e561), i32(-2147483648), (_e561 < -2147483600f)), 2147483647i, (_e561 > 2147483500f)), (_e561 == _e561));
let _e579 = global_1.member.member_6.member_9.member;
let _e585 = global_1.member.member_6.member_9.member_1;
let _e590 = global_1.member.member_6.member_10;
let _e596 = ((bitcast<i32>(_e590) + ((_e525 - select(0i, 1i, (_e518 < f32(_e525)))) >> bitcast<u32>(_e534))) + (bitcast<i32>(_e579) * (((_e549 - select(0i, 1i, (_e542 < f32(_e549)))) >> bitcast<u32>(_e534)) + (bitcast<i32>(_e585) * ((_e568 - select(0i, 1i, (_e561 < f32(_e568)))) >> bitcast<u32>(_e534))))));
let _e598 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e600 = select(_e598, _e596, (_e596 < _e598));
let _e606 = global_3.member[bitcast<u32>(select(0i, _e600, (_e600 > 0i)))];
let _e612 = global_1.member.member_1;
let _e619 = (((_e612 & 64u) != 0u) || ((((select(_e492, _e489, (_e489 > _e492)) <= _e448) && ((select(_e509, _e506, (_e506 > _e509)) > _e448) || (_e606 != 0u))) && true) && ((_e612 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e261 == 0f) && (_e268 == 0f)) && (_e370 == 0f)) && (_e373 == 0f))), _e619), (_e242 == 0f)) > 1u) {
if _e280 {
break;
}
if _e280 {
break;
}
let _e626 = (_e107.member_2 == 2u);
let _e629 = (((_e107.member_2 == 1u) || _e626) || (_e107.member_2 == 5u));
if _e629 {
let _e631 = select(-1f, _e458, (_e458 > -1f));
let _e633 = select(_e453, _e631, (_e631 < _e453));
let _e640 = select(0i, select(select(i32(_e633), i32(-2147483648), (_e633 < -2147483600f)), 2147483647i, (_e633 > 2147483500f)), (_e633 == _e633));
let _e644 = (_e640 - select(0i, 1i, (_e633 < f32(_e640))));
let _e646 = select(-1f, _e468, (_e468 > -1f));
let _e648 = select(_e463, _e646, (_e646 < _e463));
let _e655 = select(0i, select(select(i32(_e648), i32(-2147483648), (_e648 < -2147483600f)), 2147483647i, (_e648 > 2147483500f)), (_e648 == _e648));
let _e659 = (_e655 - select(0i, 1i, (_e648 < f32(_e655))));
let _e661 = select(-1f, _e478, (_e478 > -1f));
let _e663 = select(_e473, _e661, (_e661 < _e473));
let _e670 = select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < -2147483600f)), 2147483647i, (_e663 > 2147483500f)), (_e663 == _e663));
let _e674 = (_e670 - select(0i, 1i, (_e663 < f32(_e670))));
let _e678 = global_1.member.member_6.member_7;
let _e682 = global_1.member.member_6.member_8;
let _e683 = (_e644 + 1i);
let _e684 = (_e659 + 1i);
let _e685 = (_e674 + 1i);
let _e690 = global_1.member.member_6.member_11.member;
let _e696 = global_1.member.member_6.member_11.member_1;
let _e707 = ((_e683 >> bitcast<u32>(4i)) + (bitcast<i32>(_e690) * ((_e684 >> bitcast<u32>(4i)) + (bitcast<i32>(_e696) * (_e685 >> bitcast<u32>(4i))))));
let _e709 = (bitcast<i32>(_e93) - 1i);
let _e711 = select(_e709, _e707, (_e707 < _e709));
let _e717 = global_2.member[bitcast<u32>(select(0i, _e711, (_e711 > 0i)))];
let _e719 = (_e683 & 15i);
let _e722 = ((_e684 & 15i) * _e678);
let _e724 = (bitcast<i32>(_e717) + ((_e685 & 15i) * _e682));
let _e725 = (_e722 + _e678);
let _e727 = (_e722 + (2i * _e678));
let _e729 = (_e722 + (3i * _e678));
let _e730 = (_e724 + _e682);
let _e732 = (_e724 + (2i * _e682));
let _e734 = (_e724 + (3i * _e682));
local_4 = type_28(array<i32, 4>(_e719, _e719, _e719, _e719), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_5 = vec3<f32>((_e458 - f32(_e644)), (_e468 - f32(_e659)), (_e478 - f32(_e674)));
let _e748 = local_4.member[0u];
let _e749 = ((_e730 + _e725) + _e748);
let _e751 = (_e749 >> bitcast<u32>(2i));
let _e754 = bitcast<u32>(((_e749 & 3i) * 8i));
let _e756 = select(_e709, _e751, (_e751 < _e709));
let _e761 = global_2.member[bitcast<u32>(select(0i, _e756, (_e756 > 0i)))];
let _e765 = (_e751 + 1i);
let _e767 = select(_e709, _e765, (_e765 < _e709));
let _e772 = global_2.member[bitcast<u32>(select(0i, _e767, (_e767 > 0i)))];
let _e779 = ((_e761 >> bitcast<u32>((_e754 & 31u))) | ((_e772 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e754) & 31u))));
let _e782 = local_4.member_1[0u];
let _e788 = f32(bitcast<i32>(((_e779 >> bitcast<u32>((_e782 & 31u))) & 255u)));
let _e791 = local_4.member_1[1u];
let _e797 = f32(bitcast<i32>(((_e779 >> bitcast<u32>((_e791 & 31u))) & 255u)));
let _e800 = local_4.member_1[2u];
let _e806 = f32(bitcast<i32>(((_e779 >> bitcast<u32>((_e800 & 31u))) & 255u)));
let _e809 = local_4.member_1[3u];
let _e816 = local_5[0u];
let _e819 = (_e788 + ((_e797 - _e788) * _e816));
let _e820 = local_5[0u];
let _e823 = (_e797 + ((_e806 - _e797) * _e820));
let _e824 = local_5[0u];
let _e827 = (_e806 + ((f32(bitcast<i32>(((_e779 >> bitcast<u32>((_e809 & 31u))) & 255u))) - _e806) * _e824));
let _e829 = local_4.member[0u];
let _e830 = ((_e730 + _e727) + _e829);
let _e832 = (_e830 >> bitcast<u32>(2i));
let _e835 = bitcast<u32>(((_e830 & 3i) * 8i));
let _e837 = select(_e709, _e832, (_e832 < _e709));
let _e842 = global_2.member[bitcast<u32>(select(0i, _e837, (_e837 > 0i)))];
let _e846 = (_e832 + 1i);
let _e848 = select(_e709, _e846, (_e846 < _e709));
let _e853 = global_2.member[bitcast<u32>(select(0i, _e848, (_e848 > 0i)))];
let _e860 = ((_e842 >> bitcast<u32>((_e835 & 31u))) | ((_e853 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e835) & 31u))));
let _e861 = local_4.member_1[0u];
let _e867 = f32(bitcast<i32>(((_e860 >> bitcast<u32>((_e861 & 31u))) & 255u)));
let _e868 = local_4.member_1[1u];
let _e874 = f32(bitcast<i32>(((_e860 >> bitcast<u32>((_e868 & 31u))) & 255u)));
let _e875 = local_4.member_1[2u];
let _e881 = f32(bitcast<i32>(((_e860 >> bitcast<u32>((_e875 & 31u))) & 255u)));
let _e882 = local_4.member_1[3u];
let _e889 = local_5[0u];
let _e893 = local_5[0u];
let _e896 = (_e874 + ((_e881 - _e874) * _e893));
let _e897 = local_5[0u];
let _e902 = local_4.member[0u];
let _e903 = ((_e732 + _e725) + _e902);
let _e905 = (_e903 >> bitcast<u32>(2i));
let _e908 = bitcast<u32>(((_e903 & 3i) * 8i));
let _e910 = select(_e709, _e905, (_e905 < _e709));
let _e915 = global_2.member[bitcast<u32>(select(0i, _e910, (_e910 > 0i)))];
let _e919 = (_e905 + 1i);
let _e921 = select(_e709, _e919, (_e919 < _e709));
let _e926 = global_2.member[bitcast<u32>(select(0i, _e921, (_e921 > 0i)))];
let _e933 = ((_e915 >> bitcast<u32>((_e908 & 31u))) | ((_e926 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e908) & 31u))));
let _e934 = local_4.member_1[0u];
let _e940 = f32(bitcast<i32>(((_e933 >> bitcast<u32>((_e934 & 31u))) & 255u)));
let _e941 = local_4.member_1[1u];
let _e947 = f32(bitcast<i32>(((_e933 >> bitcast<u32>((_e941 & 31u))) & 255u)));
let _e948 = local_4.member_1[2u];
let _e954 = f32(bitcast<i32>(((_e933 >> bitcast<u32>((_e948 & 31u))) & 255u)));
let _e955 = local_4.member_1[3u];
let _e962 = local_5[0u];
let _e965 = (_e940 + ((_e947 - _e940) * _e962));
let _e966 = local_5[0u];
let _e969 = (_e947 + ((_e954 - _e947) * _e966));
let _e970 = local_5[0u];
let _e973 = (_e954 + ((f32(bitcast<i32>(((_e933 >> bitcast<u32>((_e955 & 31u))) & 255u))) - _e954) * _e970));
let _e975 = local_4.member[0u];
let _e976 = ((_e732 + _e727) + _e975);
let _e978 = (_e976 >> bitcast<u32>(2i));
let _e981 = bitcast<u32>(((_e976 & 3i) * 8i));
let _e983 = select(_e709, _e978, (_e978 < _e709));
let _e988 = global_2.member[bitcast<u32>(select(0i, _e983, (_e983 > 0i)))];
let _e992 = (_e978 + 1i);
let _e994 = select(_e709, _e992, (_e992 < _e709));
let _e999 = global_2.member[bitcast<u32>(select(0i, _e994, (_e994 > 0i)))];
let _e1006 = ((_e988 >> bitcast<u32>((_e981 & 31u))) | ((_e999 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e981) & 31u))));
let _e1007 = local_4.member_1[0u];
let _e1013 = f32(bitcast<i32>(((_e1006 >> bitcast<u32>((_e1007 & 31u))) & 255u)));
let _e1014 = local_4.member_1[1u];
let _e1020 = f32(bitcast<i32>(((_e1006 >> bitcast<u32>((_e1014 & 31u))) & 255u)));
let _e1021 = local_4.member_1[2u];
let _e1027 = f32(bitcast<i32>(((_e1006 >> bitcast<u32>((_e1021 & 31u))) & 255u)));
let _e1028 = local_4.member_1[3u];
let _e1035 = local_5[0u];
let _e1039 = local_5[0u];
let _e1042 = (_e1020 + ((_e1027 - _e1020) * _e1039));
let _e1043 = local_5[0u];
let _e1048 = local_4.member[0u];
let _e1049 = ((_e730 + _e722) + _e1048);
let _e1051 = (_e1049 >> bitcast<u32>(2i));
let _e1054 = bitcast<u32>(((_e1049 & 3i) * 8i));
let _e1056 = select(_e709, _e1051, (_e1051 < _e709));
let _e1061 = global_2.member[bitcast<u32>(select(0i, _e1056, (_e1056 > 0i)))];
let _e1065 = (_e1051 + 1i);
let _e1067 = select(_e709, _e1065, (_e1065 < _e709));
let _e1072 = global_2.member[bitcast<u32>(select(0i, _e1067, (_e1067 > 0i)))];
let _e1079 = ((_e1061 >> bitcast<u32>((_e1054 & 31u))) | ((_e1072 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1054) & 31u))));
let _e1080 = local_4.member_1[1u];
let _e1086 = f32(bitcast<i32>(((_e1079 >> bitcast<u32>((_e1080 & 31u))) & 255u)));
let _e1087 = local_4.member_1[2u];
let _e1094 = local_5[0u];
let _e1097 = (_e1086 + ((f32(bitcast<i32>(((_e1079 >> bitcast<u32>((_e1087 & 31u))) & 255u))) - _e1086) * _e1094));
let _e1099 = local_4.member[0u];
let _e1100 = ((_e730 + _e729) + _e1099);
let _e1102 = (_e1100 >> bitcast<u32>(2i));
let _e1105 = bitcast<u32>(((_e1100 & 3i) * 8i));
let _e1107 = select(_e709, _e1102, (_e1102 < _e709));
let _e1112 = global_2.member[bitcast<u32>(select(0i, _e1107, (_e1107 > 0i)))];
let _e1116 = (_e1102 + 1i);
let _e1118 = select(_e709, _e1116, (_e1116 < _e709));
let _e1123 = global_2.member[bitcast<u32>(select(0i, _e1118, (_e1118 > 0i)))];
let _e1130 = ((_e1112 >> bitcast<u32>((_e1105 & 31u))) | ((_e1123 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1105) & 31u))));
let _e1131 = local_4.member_1[1u];
let _e1137 = f32(bitcast<i32>(((_e1130 >> bitcast<u32>((_e1131 & 31u))) & 255u)));
let _e1138 = local_4.member_1[2u];
let _e1145 = local_5[0u];
let _e1150 = local_4.member[0u];
let _e1151 = ((_e732 + _e722) + _e1150);
let _e1153 = (_e1151 >> bitcast<u32>(2i));
let _e1156 = bitcast<u32>(((_e1151 & 3i) * 8i));
let _e1158 = select(_e709, _e1153, (_e1153 < _e709));
let _e1163 = global_2.member[bitcast<u32>(select(0i, _e1158, (_e1158 > 0i)))];
let _e1167 = (_e1153 + 1i);
let _e1169 = select(_e709, _e1167, (_e1167 < _e709));
let _e1174 = global_2.member[bitcast<u32>(select(0i, _e1169, (_e1169 > 0i)))];
let _e1181 = ((_e1163 >> bitcast<u32>((_e1156 & 31u))) | ((_e1174 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1156) & 31u))));
let _e1182 = local_4.member_1[1u];
let _e1188 = f32(bitcast<i32>(((_e1181 >> bitcast<u32>((_e1182 & 31u))) & 255u)));
let _e1189 = local_4.member_1[2u];
let _e1196 = local_5[0u];
let _e1199 = (_e1188 + ((f32(bitcast<i32>(((_e1181 >> bitcast<u32>((_e1189 & 31u))) & 255u))) - _e1188) * _e1196));
let _e1201 = local_4.member[0u];
let _e1202 = ((_e732 + _e729) + _e1201);
let _e1204 = (_e1202 >> bitcast<u32>(2i));
let _e1207 = bitcast<u32>(((_e1202 & 3i) * 8i));
let _e1209 = select(_e709, _e1204, (_e1204 < _e709));
let _e1214 = global_2.member[bitcast<u32>(select(0i, _e1209, (_e1209 > 0i)))];
let _e1218 = (_e1204 + 1i);
let _e1220 = select(_e709, _e1218, (_e1218 < _e709));
let _e1225 = global_2.member[bitcast<u32>(select(0i, _e1220, (_e1220 > 0i)))];
let _e1232 = ((_e1214 >> bitcast<u32>((_e1207 & 31u))) | ((_e1225 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1207) & 31u))));
let _e1233 = local_4.member_1[1u];
let _e1239 = f32(bitcast<i32>(((_e1232 >> bitcast<u32>((_e1233 & 31u))) & 255u)));
let _e1240 = local_4.member_1[2u];
let _e1247 = local_5[0u];
let _e1252 = local_4.member[0u];
let _e1253 = ((_e724 + _e725) + _e1252);
let _e1255 = (_e1253 >> bitcast<u32>(2i));
let _e1258 = bitcast<u32>(((_e1253 & 3i) * 8i));
let _e1260 = select(_e709, _e1255, (_e1255 < _e709));
let _e1265 = global_2.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1269 = (_e1255 + 1i);
let _e1271 = select(_e709, _e1269, (_e1269 < _e709));
let _e1276 = global_2.member[bitcast<u32>(select(0i, _e1271, (_e1271 > 0i)))];
let _e1283 = ((_e1265 >> bitcast<u32>((_e1258 & 31u))) | ((_e1276 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1258) & 31u))));
let _e1284 = local_4.member_1[1u];
let _e1290 = f32(bitcast<i32>(((_e1283 >> bitcast<u32>((_e1284 & 31u))) & 255u)));
let _e1291 = local_4.member_1[2u];
let _e1298 = local_5[0u];
let _e1301 = (_e1290 + ((f32(bitcast<i32>(((_e1283 >> bitcast<u32>((_e1291 & 31u))) & 255u))) - _e1290) * _e1298));
let _e1303 = local_4.member[0u];
let _e1304 = ((_e734 + _e725) + _e1303);
let _e1306 = (_e1304 >> bitcast<u32>(2i));
let _e1309 = bitcast<u32>(((_e1304 & 3i) * 8i));
let _e1311 = select(_e709, _e1306, (_e1306 < _e709));
let _e1316 = global_2.member[bitcast<u32>(select(0i, _e1311, (_e1311 > 0i)))];
let _e1320 = (_e1306 + 1i);
let _e1322 = select(_e709, _e1320, (_e1320 < _e709));
let _e1327 = global_2.member[bitcast<u32>(select(0i, _e1322, (_e1322 > 0i)))];
let _e1334 = ((_e1316 >> bitcast<u32>((_e1309 & 31u))) | ((_e1327 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1309) & 31u))));
let _e1335 = local_4.member_1[1u];
let _e1341 = f32(bitcast<i32>(((_e1334 >> bitcast<u32>((_e1335 & 31u))) & 255u)));
let _e1342 = local_4.member_1[2u];
let _e1349 = local_5[0u];
let _e1352 = (_e1341 + ((f32(bitcast<i32>(((_e1334 >> bitcast<u32>((_e1342 & 31u))) & 255u))) - _e1341) * _e1349));
let _e1354 = local_4.member[0u];
let _e1355 = ((_e724 + _e727) + _e1354);
let _e1357 = (_e1355 >> bitcast<u32>(2i));
let _e1360 = bitcast<u32>(((_e1355 & 3i) * 8i));
let _e1362 = select(_e709, _e1357, (_e1357 < _e709));
let _e1367 = global_2.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1371 = (_e1357 + 1i);
let _e1373 = select(_e709, _e1371, (_e1371 < _e709));
let _e1378 = global_2.member[bitcast<u32>(select(0i, _e1373, (_e1373 > 0i)))];
let _e1385 = ((_e1367 >> bitcast<u32>((_e1360 & 31u))) | ((_e1378 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1360) & 31u))));
let _e1386 = local_4.member_1[1u];
let _e1392 = f32(bitcast<i32>(((_e1385 >> bitcast<u32>((_e1386 & 31u))) & 255u)));
let _e1393 = local_4.member_1[2u];
let _e1400 = local_5[0u];
let _e1405 = local_4.member[0u];
let _e1406 = ((_e734 + _e727) + _e1405);
let _e1408 = (_e1406 >> bitcast<u32>(2i));
let _e1411 = bitcast<u32>(((_e1406 & 3i) * 8i));
let _e1413 = select(_e709, _e1408, (_e1408 < _e709));
let _e1418 = global_2.member[bitcast<u32>(select(0i, _e1413, (_e1413 > 0i)))];
let _e1422 = (_e1408 + 1i);
let _e1424 = select(_e709, _e1422, (_e1422 < _e709));
let _e1429 = global_2.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1436 = ((_e1418 >> bitcast<u32>((_e1411 & 31u))) | ((_e1429 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1411) & 31u))));
let _e1437 = local_4.member_1[1u];
let _e1443 = f32(bitcast<i32>(((_e1436 >> bitcast<u32>((_e1437 & 31u))) & 255u)));
let _e1444 = local_4.member_1[2u];
let _e1451 = local_5[0u];
let _e1456 = local_5[1u];
let _e1459 = (_e823 + ((_e896 - _e823) * _e1456));
let _e1460 = local_5[1u];
let _e1463 = (_e969 + ((_e1042 - _e969) * _e1460));
let _e1464 = local_5[1u];
let _e1467 = (_e819 + (((_e867 + ((_e874 - _e867) * _e889)) - _e819) * _e1464));
let _e1468 = local_5[1u];
let _e1473 = local_5[2u];
let _e1477 = local_5[1u];
let _e1480 = (_e827 + (((_e881 + ((f32(bitcast<i32>(((_e860 >> bitcast<u32>((_e882 & 31u))) & 255u))) - _e881) * _e897)) - _e827) * _e1477));
let _e1481 = local_5[1u];
let _e1485 = local_5[2u];
let _e1489 = local_5[1u];
let _e1492 = (_e1097 + ((_e823 - _e1097) * _e1489));
let _e1493 = local_5[1u];
let _e1497 = local_5[2u];
let _e1501 = local_5[1u];
let _e1504 = (_e896 + (((_e1137 + ((f32(bitcast<i32>(((_e1130 >> bitcast<u32>((_e1138 & 31u))) & 255u))) - _e1137) * _e1145)) - _e896) * _e1501));
let _e1505 = local_5[1u];
let _e1509 = local_5[2u];
let _e1513 = local_5[1u];
let _e1516 = (_e1301 + (((_e1392 + ((f32(bitcast<i32>(((_e1385 >> bitcast<u32>((_e1393 & 31u))) & 255u))) - _e1392) * _e1400)) - _e1301) * _e1513));
let _e1517 = local_5[2u];
let _e1521 = local_5[1u];
let _e1525 = local_5[2u];
let _e1529 = local_5[2u];
let _e1536 = global_1.member.member_6.member_5;
let _e1541 = global_1.member.member_6.member_6;
let _e1542 = (((_e1459 + ((_e1463 - _e1459) * _e1529)) * _e1536) + _e1541);
let _e1544 = select(0f, _e1542, (_e1542 > 0f));
let _e1546 = select(1f, _e1544, (_e1544 < 1f));
let _e1548 = (((_e1467 + (((_e965 + (((_e1013 + ((_e1020 - _e1013) * _e1035)) - _e965) * _e1468)) - _e1467) * _e1473)) * _e1536) + _e1541);
let _e1550 = select(0f, _e1548, (_e1548 > 0f));
let _e1552 = select(1f, _e1550, (_e1550 < 1f));
let _e1554 = (((_e1480 + (((_e973 + (((_e1027 + ((f32(bitcast<i32>(((_e1006 >> bitcast<u32>((_e1028 & 31u))) & 255u))) - _e1027) * _e1043)) - _e973) * _e1481)) - _e1480) * _e1485)) * _e1536) + _e1541);
let _e1556 = select(0f, _e1554, (_e1554 > 0f));
let _e1558 = select(1f, _e1556, (_e1556 < 1f));
let _e1560 = (((_e1492 + (((_e1199 + ((_e969 - _e1199) * _e1493)) - _e1492) * _e1497)) * _e1536) + _e1541);
let _e1562 = select(0f, _e1560, (_e1560 > 0f));
let _e1564 = select(1f, _e1562, (_e1562 < 1f));
let _e1566 = (((_e1504 + (((_e1042 + (((_e1239 + ((f32(bitcast<i32>(((_e1232 >> bitcast<u32>((_e1240 & 31u))) & 255u))) - _e1239) * _e1247)) - _e1042) * _e1505)) - _e1504) * _e1509)) * _e1536) + _e1541);
let _e1568 = select(0f, _e1566, (_e1566 > 0f));
let _e1570 = select(1f, _e1568, (_e1568 < 1f));
let _e1572 = (((_e1516 + ((_e1459 - _e1516) * _e1517)) * _e1536) + _e1541);
let _e1574 = select(0f, _e1572, (_e1572 > 0f));
let _e1576 = select(1f, _e1574, (_e1574 < 1f));
let _e1578 = (((_e1463 + (((_e1352 + (((_e1443 + ((f32(bitcast<i32>(((_e1436 >> bitcast<u32>((_e1444 & 31u))) & 255u))) - _e1443) * _e1451)) - _e1352) * _e1521)) - _e1463) * _e1525)) * _e1536) + _e1541);
let _e1580 = select(0f, _e1578, (_e1578 > 0f));
let _e1582 = select(1f, _e1580, (_e1580 < 1f));
let _e1583 = (_e1546 * 1024f);
let _e1584 = (1024f - 1f);
let _e1586 = select(0f, _e1583, (_e1583 > 0f));
let _e1588 = select(_e1584, _e1586, (_e1586 < _e1584));
let _e1595 = select(0i, select(select(i32(_e1588), i32(-2147483648), (_e1588 < -2147483600f)), 2147483647i, (_e1588 > 2147483500f)), (_e1588 == _e1588));
let _e1599 = (_e1595 - select(0i, 1i, (_e1588 < f32(_e1595))));
let _e1600 = (262147i + _e1599);
let _e1602 = (bitcast<i32>(_e97) - 1i);
let _e1604 = select(_e1602, _e1600, (_e1600 < _e1602));
let _e1610 = global_4.member[bitcast<u32>(select(0i, _e1604, (_e1604 > 0i)))];
let _e1620 = select(_e1602, 262146i, (262146i < _e1602));
let _e1626 = global_4.member[bitcast<u32>(select(0i, _e1620, (_e1620 > 0i)))];
let _e1627 = bitcast<f32>(_e1626);
let _e1628 = (f32((bitcast<i32>((_e1610 & 4095u)) - 2048i)) * _e1627);
let _e1630 = select(_e1602, 262144i, (262144i < _e1602));
let _e1636 = global_4.member[bitcast<u32>(select(0i, _e1630, (_e1630 > 0i)))];
let _e1637 = bitcast<f32>(_e1636);
let _e1639 = select(_e1602, 262145i, (262145i < _e1602));
let _e1645 = global_4.member[bitcast<u32>(select(0i, _e1639, (_e1639 > 0i)))];
let _e1646 = bitcast<f32>(_e1645);
let _e1652 = ((_e1637 + (f32(bitcast<i32>((_e1610 >> bitcast<u32>(12u)))) * _e1646)) + (_e1628 * (_e1583 - f32(_e1599))));
let _e1653 = (_e1628 * 1024f);
if _e626 {
let _e1660 = ((0.5f * (_e1558 - _e1552)) * _e1653);
let _e1661 = ((0.5f * (_e1570 - _e1564)) * _e1653);
let _e1662 = ((0.5f * (_e1582 - _e1576)) * _e1653);
phi_3830_ = type_29(_e1652, vec3<f32>(_e1660, _e1661, _e1662), vec3<f32>((_e1660 * _e1652), (_e1661 * _e1652), (_e1662 * _e1652)));
} else {
let _e1669 = (_e1552 * 1024f);
let _e1671 = select(0f, _e1669, (_e1669 > 0f));
let _e1673 = select(_e1584, _e1671, (_e1671 < _e1584));
let _e1680 = select(0i, select(select(i32(_e1673), i32(-2147483648), (_e1673 < -2147483600f)), 2147483647i, (_e1673 > 2147483500f)), (_e1673 == _e1673));
let _e1684 = (_e1680 - select(0i, 1i, (_e1673 < f32(_e1680))));
let _e1685 = (262147i + _e1684);
let _e1687 = select(_e1602, _e1685, (_e1685 < _e1602));
let _e1693 = global_4.member[bitcast<u32>(select(0i, _e1687, (_e1687 > 0i)))];
let _e1708 = ((_e1637 + (f32(bitcast<i32>((_e1693 >> bitcast<u32>(12u)))) * _e1646)) + ((f32((bitcast<i32>((_e1693 & 4095u)) - 2048i)) * _e1627) * (_e1669 - f32(_e1684))));
let _e1709 = (_e1558 * 1024f);
let _e1711 = select(0f, _e1709, (_e1709 > 0f));
let _e1713 = select(_e1584, _e1711, (_e1711 < _e1584));
let _e1720 = select(0i, select(select(i32(_e1713), i32(-2147483648), (_e1713 < -2147483600f)), 2147483647i, (_e1713 > 2147483500f)), (_e1713 == _e1713));
let _e1724 = (_e1720 - select(0i, 1i, (_e1713 < f32(_e1720))));
let _e1725 = (262147i + _e1724);
let _e1727 = select(_e1602, _e1725, (_e1725 < _e1602));
let _e1733 = global_4.member[bitcast<u32>(select(0i, _e1727, (_e1727 > 0i)))];
let _e1748 = ((_e1637 + (f32(bitcast<i32>((_e1733 >> bitcast<u32>(12u)))) * _e1646)) + ((f32((bitcast<i32>((_e1733 & 4095u)) - 2048i)) * _e1627) * (_e1709 - f32(_e1724))));
let _e1749 = (_e1564 * 1024f);
let _e1751 = select(0f, _e1749, (_e1749 > 0f));
let _e1753 = select(_e1584, _e1751, (_e1751 < _e1584));
let _e1760 = select(0i, select(select(i32(_e1753), i32(-2147483648), (_e1753 < -2147483600f)), 2147483647i, (_e1753 > 2147483500f)), (_e1753 == _e1753));
let _e1764 = (_e1760 - select(0i, 1i, (_e1753 < f32(_e1760))));
let _e1765 = (262147i + _e1764);
let _e1767 = select(_e1602, _e1765, (_e1765 < _e1602));
let _e1773 = global_4.member[bitcast<u32>(select(0i, _e1767, (_e1767 > 0i)))];
let _e1788 = ((_e1637 + (f32(bitcast<i32>((_e1773 >> bitcast<u32>(12u)))) * _e1646)) + ((f32((bitcast<i32>((_e1773 & 4095u)) - 2048i)) * _e1627) * (_e1749 - f32(_e1764))));
let _e1789 = (_e1570 * 1024f);
let _e1791 = select(0f, _e1789, (_e1789 > 0f));
let _e1793 = select(_e1584, _e1791, (_e1791 < _e1584));
let _e1800 = select(0i, select(select(i32(_e1793), i32(-2147483648), (_e1793 < -2147483600f)), 2147483647i, (_e1793 > 2147483500f)), (_e1793 == _e1793));
let _e1804 = (_e1800 - select(0i, 1i, (_e1793 < f32(_e1800))));
let _e1805 = (262147i + _e1804);
let _e1807 = select(_e1602, _e1805, (_e1805 < _e1602));
let _e1813 = global_4.member[bitcast<u32>(select(0i, _e1807, (_e1807 > 0i)))];
let _e1828 = ((_e1637 + (f32(bitcast<i32>((_e1813 >> bitcast<u32>(12u)))) * _e1646)) + ((f32((bitcast<i32>((_e1813 & 4095u)) - 2048i)) * _e1627) * (_e1789 - f32(_e1804))));
let _e1829 = (_e1576 * 1024f);
let _e1831 = select(0f, _e1829, (_e1829 > 0f));
let _e1833 = select(_e1584, _e1831, (_e1831 < _e1584));
let _e1840 = select(0i, select(select(i32(_e1833), i32(-2147483648), (_e1833 < -2147483600f)), 2147483647i, (_e1833 > 2147483500f)), (_e1833 == _e1833));
let _e1844 = (_e1840 - select(0i, 1i, (_e1833 < f32(_e1840))));
let _e1845 = (262147i + _e1844);
let _e1847 = select(_e1602, _e1845, (_e1845 < _e1602));
let _e1853 = global_4.member[bitcast<u32>(select(0i, _e1847, (_e1847 > 0i)))];
let _e1868 = ((_e1637 + (f32(bitcast<i32>((_e1853 >> bitcast<u32>(12u)))) * _e1646)) + ((f32((bitcast<i32>((_e1853 & 4095u)) - 2048i)) * _e1627) * (_e1829 - f32(_e1844))));
let _e1869 = (_e1582 * 1024f);
let _e1871 = select(0f, _e1869, (_e1869 > 0f));
let _e1873 = select(_e1584, _e1871, (_e1871 < _e1584));
let _e1880 = select(0i, select(select(i32(_e1873), i32(-2147483648), (_e1873 < -2147483600f)), 2147483647i, (_e1873 > 2147483500f)), (_e1873 == _e1873));
let _e1884 = (_e1880 - select(0i, 1i, (_e1873 < f32(_e1880))));
let _e1885 = (262147i + _e1884);
let _e1887 = select(_e1602, _e1885, (_e1885 < _e1602));
let _e1893 = global_4.member[bitcast<u32>(select(0i, _e1887, (_e1887 > 0i)))];
let _e1908 = ((_e1637 + (f32(bitcast<i32>((_e1893 >> bitcast<u32>(12u)))) * _e1646)) + ((f32((bitcast<i32>((_e1893 & 4095u)) - 2048i)) * _e1627) * (_e1869 - f32(_e1884))));
let _e1909 = (_e1748 - _e1708);
let _e1911 = (_e1828 - _e1788);
let _e1913 = (_e1908 - _e1868);
phi_3830_ = type_29(_e1652, vec3<f32>((0.5f * _e1909), (0.5f * _e1911), (0.5f * _e1913)), vec3<f32>((0.25f * (_e1909 * (_e1748 + _e1708))), (0.25f * (_e1911 * (_e1828 + _e1788))), (0.25f * (_e1913 * (_e1908 + _e1868)))));
}
let _e1928 = phi_3830_;
let _e1943 = select(0f, 1f, ((((((_e432 >= -0.5f) && (_e432 <= _e454)) && (_e438 >= -0.5f)) && (_e438 <= _e464)) && (_e444 >= -0.5f)) && (_e444 <= _e474)));
let _e1945 = (0.5f * (_e1558 - _e1552));
let _e1947 = (0.5f * (_e1570 - _e1564));
let _e1949 = (0.5f * (_e1582 - _e1576));
let _e1955 = global_1.member.member_6.member.member.member;
let _e1961 = global_1.member.member_6.member.member.member_1;
let _e1967 = global_1.member.member_6.member.member.member_2;
let _e1973 = global_1.member.member_6.member_1.member.member;
let _e1979 = global_1.member.member_6.member_1.member.member_1;
let _e1985 = global_1.member.member_6.member_1.member.member_2;
let _e1991 = global_1.member.member_6.member_2.member.member;
let _e1997 = global_1.member.member_6.member_2.member.member_1;
let _e2003 = global_1.member.member_6.member_2.member.member_2;
phi_4532_ = type_30(_e1546, vec3<f32>(((((_e1955 * _e1945) + (_e1973 * _e1947)) + (_e1991 * _e1949)) * _e1943), ((((_e1961 * _e1945) + (_e1979 * _e1947)) + (_e1997 * _e1949)) * _e1943), ((((_e1967 * _e1945) + (_e1985 * _e1947)) + (_e2003 * _e1949)) * _e1943)), _e1928.member, vec3<f32>(((((_e1955 * _e1928.member_2.x) + (_e1973 * _e1928.member_2.y)) + (_e1991 * _e1928.member_2.z)) * _e1943), ((((_e1961 * _e1928.member_2.x) + (_e1979 * _e1928.member_2.y)) + (_e1997 * _e1928.member_2.z)) * _e1943), ((((_e1967 * _e1928.member_2.x) + (_e1985 * _e1928.member_2.y)) + (_e2003 * _e1928.member_2.z)) * _e1943)), vec3<f32>(((((_e1955 * _e1928.member_1.x) + (_e1973 * _e1928.member_1.y)) + (_e1991 * _e1928.member_1.z)) * _e1943), ((((_e1961 * _e1928.member_1.x) + (_e1979 * _e1928.member_1.y)) + (_e1997 * _e1928.member_1.z)) * _e1943), ((((_e1967 * _e1928.member_1.x) + (_e1985 * _e1928.member_1.y)) + (_e2003 * _e1928.member_1.z)) * _e1943)));
} else {
let _e2069 = select(-1f, _e458, (_e458 > -1f));
let _e2071 = select(_e453, _e2069, (_e2069 < _e453));
let _e2078 = select(0i, select(select(i32(_e2071), i32(-2147483648), (_e2071 < -2147483600f)), 2147483647i, (_e2071 > 2147483500f)), (_e2071 == _e2071));
let _e2082 = (_e2078 - select(0i, 1i, (_e2071 < f32(_e2078))));
let _e2084 = select(-1f, _e468, (_e468 > -1f));
let _e2086 = select(_e463, _e2084, (_e2084 < _e463));
let _e2093 = select(0i, select(select(i32(_e2086), i32(-2147483648), (_e2086 < -2147483600f)), 2147483647i, (_e2086 > 2147483500f)), (_e2086 == _e2086));
let _e2097 = (_e2093 - select(0i, 1i, (_e2086 < f32(_e2093))));
let _e2099 = select(-1f, _e478, (_e478 > -1f));
let _e2101 = select(_e473, _e2099, (_e2099 < _e473));
let _e2108 = select(0i, select(select(i32(_e2101), i32(-2147483648), (_e2101 < -2147483600f)), 2147483647i, (_e2101 > 2147483500f)), (_e2101 == _e2101));
let _e2112 = (_e2108 - select(0i, 1i, (_e2101 < f32(_e2108))));
let _e2116 = global_1.member.member_6.member_7;
let _e2120 = global_1.member.member_6.member_8;
let _e2121 = (_e2082 + 1i);
let _e2122 = (_e2097 + 1i);
let _e2123 = (_e2112 + 1i);
let _e2128 = global_1.member.member_6.member_11.member;
let _e2134 = global_1.member.member_6.member_11.member_1;
let _e2145 = ((_e2121 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2128) * ((_e2122 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2134) * (_e2123 >> bitcast<u32>(4i))))));
let _e2147 = (bitcast<i32>(_e93) - 1i);
let _e2149 = select(_e2147, _e2145, (_e2145 < _e2147));
let _e2155 = global_2.member[bitcast<u32>(select(0i, _e2149, (_e2149 > 0i)))];
let _e2157 = (_e2121 & 15i);
let _e2160 = ((_e2122 & 15i) * _e2116);
let _e2162 = (bitcast<i32>(_e2155) + ((_e2123 & 15i) * _e2120));
let _e2163 = (_e2160 + _e2116);
let _e2165 = (_e2160 + (2i * _e2116));
let _e2166 = (_e2162 + _e2120);
let _e2168 = (_e2162 + (2i * _e2120));
local_2 = type_28(array<i32, 4>(_e2157, _e2157, _e2157, _e2157), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = vec3<f32>((_e458 - f32(_e2082)), (_e468 - f32(_e2097)), (_e478 - f32(_e2112)));
let _e2182 = local_2.member[0u];
let _e2183 = ((_e2166 + _e2163) + _e2182);
let _e2185 = (_e2183 >> bitcast<u32>(2i));
let _e2188 = bitcast<u32>(((_e2183 & 3i) * 8i));
let _e2190 = select(_e2147, _e2185, (_e2185 < _e2147));
let _e2195 = global_2.member[bitcast<u32>(select(0i, _e2190, (_e2190 > 0i)))];
let _e2199 = (_e2185 + 1i);
let _e2201 = select(_e2147, _e2199, (_e2199 < _e2147));
let _e2206 = global_2.member[bitcast<u32>(select(0i, _e2201, (_e2201 > 0i)))];
let _e2213 = ((_e2195 >> bitcast<u32>((_e2188 & 31u))) | ((_e2206 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2188) & 31u))));
let _e2216 = local_2.member_1[1u];
let _e2222 = f32(bitcast<i32>(((_e2213 >> bitcast<u32>((_e2216 & 31u))) & 255u)));
let _e2225 = local_2.member_1[2u];
let _e2232 = local_3[0u];
let _e2235 = (_e2222 + ((f32(bitcast<i32>(((_e2213 >> bitcast<u32>((_e2225 & 31u))) & 255u))) - _e2222) * _e2232));
let _e2237 = local_2.member[0u];
let _e2238 = ((_e2166 + _e2165) + _e2237);
let _e2240 = (_e2238 >> bitcast<u32>(2i));
let _e2243 = bitcast<u32>(((_e2238 & 3i) * 8i));
let _e2245 = select(_e2147, _e2240, (_e2240 < _e2147));
let _e2250 = global_2.member[bitcast<u32>(select(0i, _e2245, (_e2245 > 0i)))];
let _e2254 = (_e2240 + 1i);
let _e2256 = select(_e2147, _e2254, (_e2254 < _e2147));
let _e2261 = global_2.member[bitcast<u32>(select(0i, _e2256, (_e2256 > 0i)))];
let _e2268 = ((_e2250 >> bitcast<u32>((_e2243 & 31u))) | ((_e2261 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2243) & 31u))));
let _e2269 = local_2.member_1[1u];
let _e2275 = f32(bitcast<i32>(((_e2268 >> bitcast<u32>((_e2269 & 31u))) & 255u)));
let _e2276 = local_2.member_1[2u];
let _e2283 = local_3[0u];
let _e2288 = local_3[1u];
let _e2291 = (_e2235 + (((_e2275 + ((f32(bitcast<i32>(((_e2268 >> bitcast<u32>((_e2276 & 31u))) & 255u))) - _e2275) * _e2283)) - _e2235) * _e2288));
let _e2293 = local_2.member[0u];
let _e2294 = ((_e2168 + _e2163) + _e2293);
let _e2296 = (_e2294 >> bitcast<u32>(2i));
let _e2299 = bitcast<u32>(((_e2294 & 3i) * 8i));
let _e2301 = select(_e2147, _e2296, (_e2296 < _e2147));
let _e2306 = global_2.member[bitcast<u32>(select(0i, _e2301, (_e2301 > 0i)))];
let _e2310 = (_e2296 + 1i);
let _e2312 = select(_e2147, _e2310, (_e2310 < _e2147));
let _e2317 = global_2.member[bitcast<u32>(select(0i, _e2312, (_e2312 > 0i)))];
let _e2324 = ((_e2306 >> bitcast<u32>((_e2299 & 31u))) | ((_e2317 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2299) & 31u))));
let _e2325 = local_2.member_1[1u];
let _e2331 = f32(bitcast<i32>(((_e2324 >> bitcast<u32>((_e2325 & 31u))) & 255u)));
let _e2332 = local_2.member_1[2u];
let _e2339 = local_3[0u];
let _e2342 = (_e2331 + ((f32(bitcast<i32>(((_e2324 >> bitcast<u32>((_e2332 & 31u))) & 255u))) - _e2331) * _e2339));
let _e2344 = local_2.member[0u];
let _e2345 = ((_e2168 + _e2165) + _e2344);
let _e2347 = (_e2345 >> bitcast<u32>(2i));
let _e2350 = bitcast<u32>(((_e2345 & 3i) * 8i));
let _e2352 = select(_e2147, _e2347, (_e2347 < _e2147));
let _e2357 = global_2.member[bitcast<u32>(select(0i, _e2352, (_e2352 > 0i)))];
let _e2361 = (_e2347 + 1i);
let _e2363 = select(_e2147, _e2361, (_e2361 < _e2147));
let _e2368 = global_2.member[bitcast<u32>(select(0i, _e2363, (_e2363 > 0i)))];
let _e2375 = ((_e2357 >> bitcast<u32>((_e2350 & 31u))) | ((_e2368 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2350) & 31u))));
let _e2376 = local_2.member_1[1u];
let _e2382 = f32(bitcast<i32>(((_e2375 >> bitcast<u32>((_e2376 & 31u))) & 255u)));
let _e2383 = local_2.member_1[2u];
let _e2390 = local_3[0u];
let _e2394 = local_3[1u];
let _e2399 = local_3[2u];
let _e2406 = global_1.member.member_6.member_5;
let _e2411 = global_1.member.member_6.member_6;
let _e2412 = (((_e2291 + (((_e2342 + (((_e2382 + ((f32(bitcast<i32>(((_e2375 >> bitcast<u32>((_e2383 & 31u))) & 255u))) - _e2382) * _e2390)) - _e2342) * _e2394)) - _e2291) * _e2399)) * _e2406) + _e2411);
let _e2414 = select(0f, _e2412, (_e2412 > 0f));
phi_4532_ = type_30(select(1f, _e2414, (_e2414 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2419 = phi_4532_;
let _e2421 = select(-0.5f, _e396, (_e396 > -0.5f));
let _e2423 = select(_e454, _e2421, (_e2421 < _e454));
let _e2425 = select(-0.5f, _e411, (_e411 > -0.5f));
let _e2427 = select(_e464, _e2425, (_e2425 < _e464));
let _e2429 = select(-0.5f, _e426, (_e426 > -0.5f));
let _e2431 = select(_e474, _e2429, (_e2429 < _e474));
let _e2433 = select(-1f, _e2423, (_e2423 > -1f));
let _e2435 = select(_e453, _e2433, (_e2433 < _e453));
let _e2442 = select(0i, select(select(i32(_e2435), i32(-2147483648), (_e2435 < -2147483600f)), 2147483647i, (_e2435 > 2147483500f)), (_e2435 == _e2435));
let _e2446 = (_e2442 - select(0i, 1i, (_e2435 < f32(_e2442))));
let _e2448 = select(-1f, _e2427, (_e2427 > -1f));
let _e2450 = select(_e463, _e2448, (_e2448 < _e463));
let _e2457 = select(0i, select(select(i32(_e2450), i32(-2147483648), (_e2450 < -2147483600f)), 2147483647i, (_e2450 > 2147483500f)), (_e2450 == _e2450));
let _e2461 = (_e2457 - select(0i, 1i, (_e2450 < f32(_e2457))));
let _e2463 = select(-1f, _e2431, (_e2431 > -1f));
let _e2465 = select(_e473, _e2463, (_e2463 < _e473));
let _e2472 = select(0i, select(select(i32(_e2465), i32(-2147483648), (_e2465 < -2147483600f)), 2147483647i, (_e2465 > 2147483500f)), (_e2465 == _e2465));
let _e2476 = (_e2472 - select(0i, 1i, (_e2465 < f32(_e2472))));
let _e2480 = global_1.member.member_6.member_7;
let _e2484 = global_1.member.member_6.member_8;
let _e2485 = (_e2446 + 1i);
let _e2486 = (_e2461 + 1i);
let _e2487 = (_e2476 + 1i);
let _e2492 = global_1.member.member_6.member_11.member;
let _e2498 = global_1.member.member_6.member_11.member_1;
let _e2509 = ((_e2485 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2492) * ((_e2486 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2498) * (_e2487 >> bitcast<u32>(4i))))));
let _e2511 = (bitcast<i32>(_e93) - 1i);
let _e2513 = select(_e2511, _e2509, (_e2509 < _e2511));
let _e2519 = global_2.member[bitcast<u32>(select(0i, _e2513, (_e2513 > 0i)))];
let _e2521 = (_e2485 & 15i);
let _e2524 = ((_e2486 & 15i) * _e2480);
let _e2526 = (bitcast<i32>(_e2519) + ((_e2487 & 15i) * _e2484));
let _e2527 = (_e2524 + _e2480);
let _e2529 = (_e2524 + (2i * _e2480));
let _e2530 = (_e2526 + _e2484);
let _e2532 = (_e2526 + (2i * _e2484));
local = type_28(array<i32, 4>(_e2521, _e2521, _e2521, _e2521), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_1 = vec3<f32>((_e2423 - f32(_e2446)), (_e2427 - f32(_e2461)), (_e2431 - f32(_e2476)));
let _e2546 = local.member[0u];
let _e2547 = ((_e2530 + _e2527) + _e2546);
let _e2549 = (_e2547 >> bitcast<u32>(2i));
let _e2552 = bitcast<u32>(((_e2547 & 3i) * 8i));
let _e2554 = select(_e2511, _e2549, (_e2549 < _e2511));
let _e2559 = global_2.member[bitcast<u32>(select(0i, _e2554, (_e2554 > 0i)))];
let _e2563 = (_e2549 + 1i);
let _e2565 = select(_e2511, _e2563, (_e2563 < _e2511));
let _e2570 = global_2.member[bitcast<u32>(select(0i, _e2565, (_e2565 > 0i)))];
let _e2577 = ((_e2559 >> bitcast<u32>((_e2552 & 31u))) | ((_e2570 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2552) & 31u))));
let _e2580 = local.member_1[1u];
let _e2586 = f32(bitcast<i32>(((_e2577 >> bitcast<u32>((_e2580 & 31u))) & 255u)));
let _e2589 = local.member_1[2u];
let _e2596 = local_1[0u];
let _e2599 = (_e2586 + ((f32(bitcast<i32>(((_e2577 >> bitcast<u32>((_e2589 & 31u))) & 255u))) - _e2586) * _e2596));
let _e2601 = local.member[0u];
let _e2602 = ((_e2530 + _e2529) + _e2601);
let _e2604 = (_e2602 >> bitcast<u32>(2i));
let _e2607 = bitcast<u32>(((_e2602 & 3i) * 8i));
let _e2609 = select(_e2511, _e2604, (_e2604 < _e2511));
let _e2614 = global_2.member[bitcast<u32>(select(0i, _e2609, (_e2609 > 0i)))];
let _e2618 = (_e2604 + 1i);
let _e2620 = select(_e2511, _e2618, (_e2618 < _e2511));
let _e2625 = global_2.member[bitcast<u32>(select(0i, _e2620, (_e2620 > 0i)))];
let _e2632 = ((_e2614 >> bitcast<u32>((_e2607 & 31u))) | ((_e2625 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2607) & 31u))));
let _e2633 = local.member_1[1u];
let _e2639 = f32(bitcast<i32>(((_e2632 >> bitcast<u32>((_e2633 & 31u))) & 255u)));
let _e2640 = local.member_1[2u];
let _e2647 = local_1[0u];
let _e2652 = local_1[1u];
let _e2655 = (_e2599 + (((_e2639 + ((f32(bitcast<i32>(((_e2632 >> bitcast<u32>((_e2640 & 31u))) & 255u))) - _e2639) * _e2647)) - _e2599) * _e2652));
let _e2657 = local.member[0u];
let _e2658 = ((_e2532 + _e2527) + _e2657);
let _e2660 = (_e2658 >> bitcast<u32>(2i));
let _e2663 = bitcast<u32>(((_e2658 & 3i) * 8i));
let _e2665 = select(_e2511, _e2660, (_e2660 < _e2511));
let _e2670 = global_2.member[bitcast<u32>(select(0i, _e2665, (_e2665 > 0i)))];
let _e2674 = (_e2660 + 1i);
let _e2676 = select(_e2511, _e2674, (_e2674 < _e2511));
let _e2681 = global_2.member[bitcast<u32>(select(0i, _e2676, (_e2676 > 0i)))];
let _e2688 = ((_e2670 >> bitcast<u32>((_e2663 & 31u))) | ((_e2681 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2663) & 31u))));
let _e2689 = local.member_1[1u];
let _e2695 = f32(bitcast<i32>(((_e2688 >> bitcast<u32>((_e2689 & 31u))) & 255u)));
let _e2696 = local.member_1[2u];
let _e2703 = local_1[0u];
let _e2706 = (_e2695 + ((f32(bitcast<i32>(((_e2688 >> bitcast<u32>((_e2696 & 31u))) & 255u))) - _e2695) * _e2703));
let _e2708 = local.member[0u];
let _e2709 = ((_e2532 + _e2529) + _e2708);
let _e2711 = (_e2709 >> bitcast<u32>(2i));
let _e2714 = bitcast<u32>(((_e2709 & 3i) * 8i));
let _e2716 = select(_e2511, _e2711, (_e2711 < _e2511));
let _e2721 = global_2.member[bitcast<u32>(select(0i, _e2716, (_e2716 > 0i)))];
let _e2725 = (_e2711 + 1i);
let _e2727 = select(_e2511, _e2725, (_e2725 < _e2511));
let _e2732 = global_2.member[bitcast<u32>(select(0i, _e2727, (_e2727 > 0i)))];
let _e2739 = ((_e2721 >> bitcast<u32>((_e2714 & 31u))) | ((_e2732 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2714) & 31u))));
let _e2740 = local.member_1[1u];
let _e2746 = f32(bitcast<i32>(((_e2739 >> bitcast<u32>((_e2740 & 31u))) & 255u)));
let _e2747 = local.member_1[2u];
let _e2754 = local_1[0u];
let _e2758 = local_1[1u];
let _e2763 = local_1[2u];
let _e2770 = global_1.member.member_6.member_5;
let _e2775 = global_1.member.member_6.member_6;
let _e2776 = (((_e2655 + (((_e2706 + (((_e2746 + ((f32(bitcast<i32>(((_e2739 >> bitcast<u32>((_e2747 & 31u))) & 255u))) - _e2746) * _e2754)) - _e2706) * _e2758)) - _e2655) * _e2763)) * _e2770) + _e2775);
let _e2778 = select(0f, _e2776, (_e2776 > 0f));
if ((_e612 & 16u) == 0u) {
phi_5457_ = type_5(1f, 1f, 1f);
} else {
let _e2786 = global_1.member.member_14.member;
let _e2797 = ((((_e2786.member.member * _e307) + (_e2786.member.member_1 * _e316)) + (_e2786.member.member_2 * _e289)) + _e2786.member_1);
let _e2803 = ((((_e2786.member.member * _e328) + (_e2786.member.member_1 * _e333)) + (_e2786.member.member_2 * _e322)) + _e2786.member_1);
let _e2805 = select(_e2803, _e2797, (_e2797 < _e2803));
let _e2807 = select(_e2803, _e2797, (_e2797 > _e2803));
let _e2809 = (_e2807 - _e2805);
let _e2812 = (-(_e2805) / select(1e-30f, _e2809, (_e2809 > 1e-30f)));
let _e2814 = select(0f, _e2812, (_e2812 > 0f));
let _e2820 = select(select(select(1f, _e2814, (_e2814 < 1f)), 1f, (_e2807 <= 0f)), 0f, (_e2805 > 0f));
let _e2825 = global_1.member.member_14.member_1;
let _e2826 = (_e2825 != 0u);
let _e2836 = global_1.member.member_15.member;
let _e2847 = ((((_e2836.member.member * _e307) + (_e2836.member.member_1 * _e316)) + (_e2836.member.member_2 * _e289)) + _e2836.member_1);
let _e2853 = ((((_e2836.member.member * _e328) + (_e2836.member.member_1 * _e333)) + (_e2836.member.member_2 * _e322)) + _e2836.member_1);
let _e2855 = select(_e2853, _e2847, (_e2847 < _e2853));
let _e2857 = select(_e2853, _e2847, (_e2847 > _e2853));
let _e2859 = (_e2857 - _e2855);
let _e2862 = (-(_e2855) / select(1e-30f, _e2859, (_e2859 > 1e-30f)));
let _e2864 = select(0f, _e2862, (_e2862 > 0f));
let _e2870 = select(select(select(1f, _e2864, (_e2864 < 1f)), 1f, (_e2857 <= 0f)), 0f, (_e2855 > 0f));
let _e2875 = global_1.member.member_15.member_1;
let _e2876 = (_e2875 != 0u);
let _e2886 = global_1.member.member_16.member;
let _e2897 = ((((_e2886.member.member * _e307) + (_e2886.member.member_1 * _e316)) + (_e2886.member.member_2 * _e289)) + _e2886.member_1);
let _e2903 = ((((_e2886.member.member * _e328) + (_e2886.member.member_1 * _e333)) + (_e2886.member.member_2 * _e322)) + _e2886.member_1);
let _e2905 = select(_e2903, _e2897, (_e2897 < _e2903));
let _e2907 = select(_e2903, _e2897, (_e2897 > _e2903));
let _e2909 = (_e2907 - _e2905);
let _e2912 = (-(_e2905) / select(1e-30f, _e2909, (_e2909 > 1e-30f)));
let _e2914 = select(0f, _e2912, (_e2912 > 0f));
let _e2920 = select(select(select(1f, _e2914, (_e2914 < 1f)), 1f, (_e2907 <= 0f)), 0f, (_e2905 > 0f));
let _e2925 = global_1.member.member_16.member_1;
let _e2926 = (_e2925 != 0u);
let _e2936 = global_1.member.member_17.member;
let _e2947 = ((((_e2936.member.member * _e307) + (_e2936.member.member_1 * _e316)) + (_e2936.member.member_2 * _e289)) + _e2936.member_1);
let _e2953 = ((((_e2936.member.member * _e328) + (_e2936.member.member_1 * _e333)) + (_e2936.member.member_2 * _e322)) + _e2936.member_1);
let _e2955 = select(_e2953, _e2947, (_e2947 < _e2953));
let _e2957 = select(_e2953, _e2947, (_e2947 > _e2953));
let _e2959 = (_e2957 - _e2955);
let _e2962 = (-(_e2955) / select(1e-30f, _e2959, (_e2959 > 1e-30f)));
let _e2964 = select(0f, _e2962, (_e2962 > 0f));
let _e2970 = select(select(select(1f, _e2964, (_e2964 < 1f)), 1f, (_e2957 <= 0f)), 0f, (_e2955 > 0f));
let _e2975 = global_1.member.member_17.member_1;
let _e2976 = (_e2975 != 0u);
phi_5457_ = type_5(((((1f * _e2820) * _e2870) * _e2920) * _e2970), ((((1f * select(1f, _e2820, _e2826)) * select(1f, _e2870, _e2876)) * select(1f, _e2920, _e2926)) * select(1f, _e2970, _e2976)), ((((1f * select(1f, 0f, (_e2826 && (_e2803 > 0f)))) * select(1f, 0f, (_e2876 && (_e2853 > 0f)))) * select(1f, 0f, (_e2926 && (_e2903 > 0f)))) * select(1f, 0f, (_e2976 && (_e2953 > 0f)))));
}
let _e2985 = phi_5457_;
let _e2986 = (_e328 - _e307);
let _e2987 = (_e333 - _e316);
let _e2988 = (_e322 - _e289);
let _e2993 = (((_e2986 * _e2986) + (_e2987 * _e2987)) + (_e2988 * _e2988));
let _e2997 = (_e484 < 1e-12f);
let _e2999 = (1f / select(_e479, 1f, _e2997));
let _e3001 = ((-0.5f - _e396) * _e2999);
let _e3003 = ((_e454 - _e396) * _e2999);
let _e3009 = select(_e3003, _e3001, (_e3001 < _e3003));
let _e3011 = select(0f, _e3009, (_e3009 > 0f));
let _e3014 = select(select(1f, _e3011, (_e3011 < 1f)), select(2f, 0f, ((_e396 >= -0.5f) && (_e396 <= _e454))), _e2997);
let _e3016 = select(_e3003, _e3001, (_e3001 > _e3003));
let _e3018 = select(0f, _e3016, (_e3016 > 0f));
let _e3021 = select(select(1f, _e3018, (_e3018 < 1f)), 1f, _e2997);
let _e3022 = (_e487 < 1e-12f);
let _e3024 = (1f / select(_e480, 1f, _e3022));
let _e3026 = ((-0.5f - _e411) * _e3024);
let _e3028 = ((_e464 - _e411) * _e3024);
let _e3034 = select(_e3028, _e3026, (_e3026 < _e3028));
let _e3036 = select(0f, _e3034, (_e3034 > 0f));
let _e3039 = select(select(1f, _e3036, (_e3036 < 1f)), select(2f, 0f, ((_e411 >= -0.5f) && (_e411 <= _e464))), _e3022);
let _e3041 = select(_e3028, _e3026, (_e3026 > _e3028));
let _e3043 = select(0f, _e3041, (_e3041 > 0f));
let _e3046 = select(select(1f, _e3043, (_e3043 < 1f)), 1f, _e3022);
let _e3047 = (_e492 < 1e-12f);
let _e3049 = (1f / select(_e481, 1f, _e3047));
let _e3051 = ((-0.5f - _e426) * _e3049);
let _e3053 = ((_e474 - _e426) * _e3049);
let _e3059 = select(_e3053, _e3051, (_e3051 < _e3053));
let _e3061 = select(0f, _e3059, (_e3059 > 0f));
let _e3064 = select(select(1f, _e3061, (_e3061 < 1f)), select(2f, 0f, ((_e426 >= -0.5f) && (_e426 <= _e474))), _e3047);
let _e3066 = select(_e3053, _e3051, (_e3051 > _e3053));
let _e3068 = select(0f, _e3066, (_e3066 > 0f));
let _e3071 = select(select(1f, _e3068, (_e3068 < 1f)), 1f, _e3047);
let _e3073 = select(_e3046, _e3021, (_e3021 < _e3046));
let _e3077 = select(_e3039, _e3014, (_e3014 > _e3039));
let _e3080 = (select(_e3071, _e3073, (_e3073 < _e3071)) - select(_e3064, _e3077, (_e3077 > _e3064)));
let _e3087 = global_1.member.member_5.member_3;
let _e3088 = ((sqrt(select(0f, _e2993, (_e2993 > 0f))) * select(0f, _e3080, (_e3080 > 0f))) * _e3087);
let _e3090 = (select(1f, _e2778, (_e2778 < 1f)) * 255f);
let _e3091 = (_e2419.member * 255f);
let _e3092 = (255f - 1f);
let _e3094 = select(0f, _e3090, (_e3090 > 0f));
let _e3096 = select(_e3092, _e3094, (_e3094 < _e3092));
let _e3103 = select(0i, select(select(i32(_e3096), i32(-2147483648), (_e3096 < -2147483600f)), 2147483647i, (_e3096 > 2147483500f)), (_e3096 == _e3096));
let _e3107 = (_e3103 - select(0i, 1i, (_e3096 < f32(_e3103))));
let _e3109 = select(0f, _e3091, (_e3091 > 0f));
let _e3111 = select(_e3092, _e3109, (_e3109 < _e3092));
let _e3118 = select(0i, select(select(i32(_e3111), i32(-2147483648), (_e3111 < -2147483600f)), 2147483647i, (_e3111 > 2147483500f)), (_e3111 == _e3111));
let _e3122 = (_e3118 - select(0i, 1i, (_e3111 < f32(_e3118))));
let _e3125 = (((_e3107 * 256i) + _e3122) * 4i);
let _e3127 = (_e3090 - f32(_e3107));
let _e3129 = (_e3091 - f32(_e3122));
let _e3131 = (bitcast<i32>(_e97) - 1i);
let _e3133 = select(_e3131, _e3125, (_e3125 < _e3131));
let _e3139 = global_4.member[bitcast<u32>(select(0i, _e3133, (_e3133 > 0i)))];
let _e3140 = (_e3125 + 4i);
let _e3142 = select(_e3131, _e3140, (_e3140 < _e3131));
let _e3148 = global_4.member[bitcast<u32>(select(0i, _e3142, (_e3142 > 0i)))];
let _e3149 = (_e3125 + 1024i);
let _e3151 = select(_e3131, _e3149, (_e3149 < _e3131));
let _e3157 = global_4.member[bitcast<u32>(select(0i, _e3151, (_e3151 > 0i)))];
let _e3158 = (_e3125 + 1028i);
let _e3160 = select(_e3131, _e3158, (_e3158 < _e3131));
let _e3166 = global_4.member[bitcast<u32>(select(0i, _e3160, (_e3160 > 0i)))];
let _e3171 = (bitcast<f32>(((_e3139 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3179 = (_e3171 + (((bitcast<f32>(((_e3148 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3171) * _e3129));
let _e3184 = (bitcast<f32>(((_e3157 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3208 = (bitcast<f32>((((_e3139 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3216 = (_e3208 + (((bitcast<f32>((((_e3148 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3208) * _e3129));
let _e3221 = (bitcast<f32>((((_e3157 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3233 = (_e3125 + 1i);
let _e3235 = select(_e3131, _e3233, (_e3233 < _e3131));
let _e3241 = global_4.member[bitcast<u32>(select(0i, _e3235, (_e3235 > 0i)))];
let _e3242 = (_e3125 + 5i);
let _e3244 = select(_e3131, _e3242, (_e3242 < _e3131));
let _e3250 = global_4.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3251 = (_e3125 + 1025i);
let _e3253 = select(_e3131, _e3251, (_e3251 < _e3131));
let _e3259 = global_4.member[bitcast<u32>(select(0i, _e3253, (_e3253 > 0i)))];
let _e3260 = (_e3125 + 1029i);
let _e3262 = select(_e3131, _e3260, (_e3260 < _e3131));
let _e3268 = global_4.member[bitcast<u32>(select(0i, _e3262, (_e3262 > 0i)))];
let _e3273 = (bitcast<f32>(((_e3241 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3281 = (_e3273 + (((bitcast<f32>(((_e3250 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3273) * _e3129));
let _e3286 = (bitcast<f32>(((_e3259 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3310 = (bitcast<f32>((((_e3241 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3318 = (_e3310 + (((bitcast<f32>((((_e3250 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3310) * _e3129));
let _e3323 = (bitcast<f32>((((_e3259 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3338 = (_e3088 * _e2985.member_1);
let _e3340 = -(((_e3216 + (((_e3221 + (((bitcast<f32>((((_e3166 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3221) * _e3129)) - _e3216) * _e3127)) * _e3338));
let _e3342 = select(-87f, _e3340, (_e3340 > -87f));
let _e3344 = select(88f, _e3342, (_e3342 < 88f));
let _e3346 = ((_e3344 * 1.442695f) + 0.5f);
let _e3348 = select(-127f, _e3346, (_e3346 > -127f));
let _e3350 = select(128f, _e3348, (_e3348 < 128f));
let _e3357 = select(0i, select(select(i32(_e3350), i32(-2147483648), (_e3350 < -2147483600f)), 2147483647i, (_e3350 > 2147483500f)), (_e3350 == _e3350));
let _e3361 = (_e3357 - select(0i, 1i, (_e3350 < f32(_e3357))));
let _e3362 = f32(_e3361);
let _e3366 = ((_e3344 - (_e3362 * 0.6933594f)) - (_e3362 * -2.1219444e-4f));
let _e3388 = -(((_e3281 + (((_e3286 + (((bitcast<f32>(((_e3268 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3286) * _e3129)) - _e3281) * _e3127)) * _e3338));
let _e3390 = select(-87f, _e3388, (_e3388 > -87f));
let _e3392 = select(88f, _e3390, (_e3390 < 88f));
let _e3394 = ((_e3392 * 1.442695f) + 0.5f);
let _e3396 = select(-127f, _e3394, (_e3394 > -127f));
let _e3398 = select(128f, _e3396, (_e3396 < 128f));
let _e3405 = select(0i, select(select(i32(_e3398), i32(-2147483648), (_e3398 < -2147483600f)), 2147483647i, (_e3398 > 2147483500f)), (_e3398 == _e3398));
let _e3409 = (_e3405 - select(0i, 1i, (_e3398 < f32(_e3405))));
let _e3410 = f32(_e3409);
let _e3414 = ((_e3392 - (_e3410 * 0.6933594f)) - (_e3410 * -2.1219444e-4f));
let _e3436 = -(((_e3318 + (((_e3323 + (((bitcast<f32>((((_e3268 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3323) * _e3129)) - _e3318) * _e3127)) * _e3338));
let _e3438 = select(-87f, _e3436, (_e3436 > -87f));
let _e3440 = select(88f, _e3438, (_e3438 < 88f));
let _e3442 = ((_e3440 * 1.442695f) + 0.5f);
let _e3444 = select(-127f, _e3442, (_e3442 > -127f));
let _e3446 = select(128f, _e3444, (_e3444 < 128f));
let _e3453 = select(0i, select(select(i32(_e3446), i32(-2147483648), (_e3446 < -2147483600f)), 2147483647i, (_e3446 > 2147483500f)), (_e3446 == _e3446));
let _e3457 = (_e3453 - select(0i, 1i, (_e3446 < f32(_e3453))));
let _e3458 = f32(_e3457);
let _e3462 = ((_e3440 - (_e3458 * 0.6933594f)) - (_e3458 * -2.1219444e-4f));
let _e3484 = -(((_e3179 + (((_e3184 + (((bitcast<f32>(((_e3166 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3184) * _e3129)) - _e3179) * _e3127)) * (_e3088 * _e2985.member)));
let _e3486 = select(-87f, _e3484, (_e3484 > -87f));
let _e3488 = select(88f, _e3486, (_e3486 < 88f));
let _e3490 = ((_e3488 * 1.442695f) + 0.5f);
let _e3492 = select(-127f, _e3490, (_e3490 > -127f));
let _e3494 = select(128f, _e3492, (_e3492 < 128f));
let _e3501 = select(0i, select(select(i32(_e3494), i32(-2147483648), (_e3494 < -2147483600f)), 2147483647i, (_e3494 > 2147483500f)), (_e3494 == _e3494));
let _e3505 = (_e3501 - select(0i, 1i, (_e3494 < f32(_e3501))));
let _e3506 = f32(_e3505);
let _e3510 = ((_e3488 - (_e3506 * 0.6933594f)) - (_e3506 * -2.1219444e-4f));
let _e3530 = ((1f + (_e3510 * (1f + (_e3510 * (0.5f + (_e3510 * (0.16666667f + (_e3510 * (0.041666668f + (_e3510 * (0.008333334f + (_e3510 * (0.001388889f + (_e3510 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3505 + 127i)) << bitcast<u32>(23i))));
if _e629 {
let _e3545 = global_1.member.member_5.member_4;
let _e3548 = (_e2419.member_3.x * _e2985.member_2);
let _e3550 = (_e2419.member_3.y * _e2985.member_2);
let _e3552 = (_e2419.member_3.z * _e2985.member_2);
let _e3553 = (0.5f * (_e246 / _e198));
let _e3557 = (_e176 + (_e3548 * _e3553));
let _e3558 = (_e187 + (_e3550 * _e3553));
let _e3559 = (_e198 + (_e3552 * _e3553));
let _e3561 = (2f * _e246);
let _e3563 = ((_e3559 * _e3559) + (_e3561 * _e3552));
let _e3567 = (_e3559 + sqrt(select(0f, _e3563, (_e3563 > 0f))));
let _e3571 = (0.5f * (_e3561 / select(1e-6f, _e3567, (_e3567 > 1e-6f))));
let _e3575 = (_e3557 + (_e3548 * _e3571));
let _e3576 = (_e3558 + (_e3550 * _e3571));
let _e3577 = (_e3559 + (_e3552 * _e3571));
let _e3581 = (_e3545 * _e3545);
let _e3583 = (_e3577 * _e3577);
let _e3591 = (((_e3559 <= 0f) || (_e3563 <= 0f)) || ((_e3577 <= 0f) || (_e3583 <= (_e3581 * (((_e3575 * _e3575) + (_e3576 * _e3576)) + _e3583)))));
let _e3605 = (_e176 + ((_e2419.member_4.x * _e2985.member_2) * _e246));
let _e3606 = (_e187 + ((_e2419.member_4.y * _e2985.member_2) * _e246));
let _e3607 = (_e198 + ((_e2419.member_4.z * _e2985.member_2) * _e246));
let _e3609 = (_e3607 * _e3607);
let _e3618 = ((_e612 & 1u) != 0u);
phi_6481_ = select(select(select(_e3577, _e3559, _e3591), _e3607, _e3618), _e198, _e619);
phi_6482_ = select(select(select(_e3576, _e3558, _e3591), _e3606, _e3618), _e187, _e619);
phi_6483_ = select(select(select(_e3575, _e3557, _e3591), _e3605, _e3618), _e176, _e619);
phi_6484_ = (select(_e3591, ((_e3607 <= 0f) || (_e3609 <= (_e3581 * (((_e3605 * _e3605) + (_e3606 * _e3606)) + _e3609)))), _e3618) && !(_e619));
} else {
phi_6481_ = _e198;
phi_6482_ = _e187;
phi_6483_ = _e176;
phi_6484_ = false;
}
let _e3629 = phi_6481_;
let _e3631 = phi_6482_;
let _e3633 = phi_6483_;
let _e3635 = phi_6484_;
global_6.member[_e122] = (_e133 + _e261);
global_6.member[_e134] = (_e143 + _e268);
global_6.member[_e145] = (_e154 + _e370);
global_6.member[_e156] = (_e165 + _e373);
global_6.member[_e167] = _e3633;
global_6.member[_e178] = _e3631;
global_6.member[_e189] = _e3629;
global_6.member[_e200] = select((_e209 * (((1f + (_e3366 * (1f + (_e3366 * (0.5f + (_e3366 * (0.16666667f + (_e3366 * (0.041666668f + (_e3366 * (0.008333334f + (_e3366 * (0.001388889f + (_e3366 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3361 + 127i)) << bitcast<u32>(23i)))) * _e3530)), _e209, _e619);
global_6.member[_e211] = select((_e220 * (((1f + (_e3414 * (1f + (_e3414 * (0.5f + (_e3414 * (0.16666667f + (_e3414 * (0.041666668f + (_e3414 * (0.008333334f + (_e3414 * (0.001388889f + (_e3414 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3409 + 127i)) << bitcast<u32>(23i)))) * _e3530)), _e220, _e619);
global_6.member[_e222] = select((_e231 * (((1f + (_e3462 * (1f + (_e3462 * (0.5f + (_e3462 * (0.16666667f + (_e3462 * (0.041666668f + (_e3462 * (0.008333334f + (_e3462 * (0.001388889f + (_e3462 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3457 + 127i)) << bitcast<u32>(23i)))) * _e3530)), _e231, _e619);
global_6.member[_e233] = select(_e242, 1f, _e3635);
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
