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
struct type_31 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
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
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_940_: u32;
var phi_3406_: type_29;
var phi_4168_: type_30;
var phi_5117_: type_5;
var phi_6227_: type_31;
var phi_6378_: f32;
var phi_6379_: f32;
var phi_6380_: f32;
var phi_6381_: f32;
let _e85 = global;
let _e88 = arrayLength((&global_2.member));
let _e92 = arrayLength((&global_4.member));
let _e94 = arrayLength((&global_6.member));
let _e99 = global_1.member.member_2;
let _e102 = global_1.member.member;
let _e110 = (_e85.x + _e99.member);
let _e112 = (_e85.y + _e99.member_1);
if (_e110 < _e99.member_2) {
if (_e112 < _e99.member_3) {
let _e115 = (_e102.member * _e102.member_1);
let _e117 = ((_e112 * _e102.member) + _e110);
let _e118 = bitcast<i32>(_e117);
let _e120 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e122 = select(_e120, _e118, (_e118 < _e120));
let _e128 = global_5.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e129 = (_e115 + _e117);
let _e130 = bitcast<i32>(_e129);
let _e132 = select(_e120, _e130, (_e130 < _e120));
let _e138 = global_5.member[bitcast<u32>(select(0i, _e132, (_e132 > 0i)))];
let _e140 = ((2u * _e115) + _e117);
let _e141 = bitcast<i32>(_e140);
let _e143 = select(_e120, _e141, (_e141 < _e120));
let _e149 = global_5.member[bitcast<u32>(select(0i, _e143, (_e143 > 0i)))];
let _e151 = ((3u * _e115) + _e117);
let _e152 = bitcast<i32>(_e151);
let _e154 = select(_e120, _e152, (_e152 < _e120));
let _e160 = global_5.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e162 = ((4u * _e115) + _e117);
let _e163 = bitcast<i32>(_e162);
let _e165 = select(_e120, _e163, (_e163 < _e120));
let _e171 = global_5.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e173 = ((5u * _e115) + _e117);
let _e174 = bitcast<i32>(_e173);
let _e176 = select(_e120, _e174, (_e174 < _e120));
let _e182 = global_5.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = ((6u * _e115) + _e117);
let _e185 = bitcast<i32>(_e184);
let _e187 = select(_e120, _e185, (_e185 < _e120));
let _e193 = global_5.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e195 = ((7u * _e115) + _e117);
let _e196 = bitcast<i32>(_e195);
let _e198 = select(_e120, _e196, (_e196 < _e120));
let _e204 = global_5.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e206 = ((8u * _e115) + _e117);
let _e207 = bitcast<i32>(_e206);
let _e209 = select(_e120, _e207, (_e207 < _e120));
let _e215 = global_5.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e219 = global_1.member.member_8.member;
let _e223 = global_1.member.member_8.member_1;
let _e224 = (_e219 * _e223);
if (_e94 >= (_e224 * 2u)) {
let _e228 = bitcast<i32>((_e112 * _e219));
let _e230 = bitcast<i32>(_e110);
let _e235 = global_6.member[bitcast<u32>((_e228 + _e230))];
let _e241 = global_6.member[bitcast<u32>(((bitcast<i32>(_e224) + _e228) + _e230))];
let _e242 = f32(_e230);
let _e244 = f32(bitcast<i32>(_e112));
let _e250 = global_1.member.member_5.member;
let _e254 = global_1.member.member_8.member_8;
let _e255 = (_e250 - _e254);
let _e259 = global_1.member.member_8.member_2;
let _e263 = global_1.member.member_8.member_6;
let _e270 = global_1.member.member_8.member_4;
let _e272 = ((_e259 + (_e263 * _e255)) + (((_e242 - _e235) + 0.5f) * _e270));
let _e276 = global_1.member.member_8.member_3;
let _e280 = global_1.member.member_8.member_7;
let _e285 = ((_e276 + (_e280 * _e255)) + (((_e244 - _e241) + 0.5f) * _e270));
let _e289 = global_1.member.member_5.member_1;
let _e290 = (_e289 - _e254);
let _e295 = ((_e259 + (_e263 * _e290)) + ((_e242 + 0.5f) * _e270));
let _e300 = ((_e276 + (_e280 * _e290)) + ((_e244 + 0.5f) * _e270));
let _e304 = global_1.member.member_6.member;
let _e315 = ((((_e304.member.member * _e272) + (_e304.member.member_1 * _e285)) + (_e304.member.member_2 * _e250)) + _e304.member_1);
let _e319 = global_1.member.member_6.member_1;
let _e330 = ((((_e319.member.member * _e272) + (_e319.member.member_1 * _e285)) + (_e319.member.member_2 * _e250)) + _e319.member_1);
let _e334 = global_1.member.member_6.member_2;
let _e345 = ((((_e334.member.member * _e272) + (_e334.member.member_1 * _e285)) + (_e334.member.member_2 * _e250)) + _e334.member_1);
let _e351 = ((((_e304.member.member * _e295) + (_e304.member.member_1 * _e300)) + (_e304.member.member_2 * _e289)) + _e304.member_1);
let _e357 = ((((_e319.member.member * _e295) + (_e319.member.member_1 * _e300)) + (_e319.member.member_2 * _e289)) + _e319.member_1);
let _e363 = ((((_e334.member.member * _e295) + (_e334.member.member_1 * _e300)) + (_e334.member.member_2 * _e289)) + _e334.member_1);
let _e369 = global_1.member.member_6.member_3.member;
let _e370 = (_e369 - 1f);
let _e379 = global_1.member.member_6.member_3.member_1;
let _e380 = (_e379 - 1f);
let _e389 = global_1.member.member_6.member_3.member_2;
let _e390 = (_e389 - 1f);
let _e409 = global_1.member.member_6.member_4;
let _e410 = (_e369 - 0.5f);
let _e412 = select(-0.5f, _e351, (_e351 > -0.5f));
let _e414 = select(_e410, _e412, (_e412 < _e410));
let _e415 = (_e379 - 0.5f);
let _e417 = select(-0.5f, _e357, (_e357 > -0.5f));
let _e419 = select(_e415, _e417, (_e417 < _e415));
let _e420 = (_e389 - 0.5f);
let _e422 = select(-0.5f, _e363, (_e363 > -0.5f));
let _e424 = select(_e420, _e422, (_e422 < _e420));
let _e430 = bitcast<f32>((bitcast<u32>((_e351 - _e315)) & 2147483647u));
let _e433 = bitcast<f32>((bitcast<u32>((_e357 - _e330)) & 2147483647u));
let _e435 = select(_e433, _e430, (_e430 > _e433));
let _e438 = bitcast<f32>((bitcast<u32>((_e363 - _e345)) & 2147483647u));
let _e447 = bitcast<f32>((bitcast<u32>((_e351 - _e414)) & 2147483647u));
let _e450 = bitcast<f32>((bitcast<u32>((_e357 - _e419)) & 2147483647u));
let _e452 = select(_e450, _e447, (_e447 > _e450));
let _e455 = bitcast<f32>((bitcast<u32>((_e363 - _e424)) & 2147483647u));
let _e459 = (_e414 + 0.5f);
let _e461 = select(0f, _e459, (_e459 > 0f));
let _e463 = select(_e370, _e461, (_e461 < _e370));
let _e470 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < -2147483600f)), 2147483647i, (_e463 > 2147483500f)), (_e463 == _e463));
let _e478 = global_1.member.member_6.member_12;
let _e479 = (_e478 & 31u);
let _e482 = (_e419 + 0.5f);
let _e484 = select(0f, _e482, (_e482 > 0f));
let _e486 = select(_e380, _e484, (_e484 < _e380));
let _e493 = select(0i, select(select(i32(_e486), i32(-2147483648), (_e486 < -2147483600f)), 2147483647i, (_e486 > 2147483500f)), (_e486 == _e486));
let _e500 = (_e424 + 0.5f);
let _e502 = select(0f, _e500, (_e500 > 0f));
let _e504 = select(_e390, _e502, (_e502 < _e390));
let _e511 = select(0i, select(select(i32(_e504), i32(-2147483648), (_e504 < -2147483600f)), 2147483647i, (_e504 > 2147483500f)), (_e504 == _e504));
let _e522 = global_1.member.member_6.member_9.member;
let _e528 = global_1.member.member_6.member_9.member_1;
let _e533 = global_1.member.member_6.member_10;
let _e539 = ((bitcast<i32>(_e533) + ((_e470 - select(0i, 1i, (_e463 < f32(_e470)))) >> bitcast<u32>(_e479))) + (bitcast<i32>(_e522) * (((_e493 - select(0i, 1i, (_e486 < f32(_e493)))) >> bitcast<u32>(_e479)) + (bitcast<i32>(_e528) * ((_e511 - select(0i, 1i, (_e504 < f32(_e511)))) >> bitcast<u32>(_e479))))));
let _e541 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e543 = select(_e541, _e539, (_e539 < _e541));
let _e549 = global_3.member[bitcast<u32>(select(0i, _e543, (_e543 > 0i)))];
let _e555 = global_1.member.member_1;
phi_940_ = select(select(7u, 3u, (((((((_e315 >= 0f) && (_e315 <= _e370)) && (_e330 >= 0f)) && (_e330 <= _e380)) && (_e345 >= 0f)) && (_e345 <= _e390)) && ((((((_e351 >= 0f) && (_e351 <= _e370)) && (_e357 >= 0f)) && (_e357 <= _e380)) && (_e363 >= 0f)) && (_e363 <= _e390)))), 1u, (((_e555 & 64u) != 0u) || ((((select(_e438, _e435, (_e435 > _e438)) <= _e409) && ((select(_e455, _e452, (_e452 > _e455)) > _e409) || (_e549 != 0u))) && true) && ((_e555 & 32u) != 0u))));
} else {
phi_940_ = 7u;
}
let _e565 = phi_940_;
if (_e565 > 1u) {
let _e570 = bitcast<i32>(((_e112 * _e219) + _e110));
let _e573 = (bitcast<i32>(_e94) - 1i);
let _e575 = select(_e573, _e570, (_e570 < _e573));
let _e581 = global_6.member[bitcast<u32>(select(0i, _e575, (_e575 > 0i)))];
let _e582 = (bitcast<i32>(_e224) + _e570);
let _e584 = select(_e573, _e582, (_e582 < _e573));
let _e590 = global_6.member[bitcast<u32>(select(0i, _e584, (_e584 > 0i)))];
let _e592 = f32(bitcast<i32>(_e110));
let _e594 = f32(bitcast<i32>(_e112));
let _e600 = global_1.member.member_5.member;
let _e604 = global_1.member.member_8.member_8;
let _e605 = (_e600 - _e604);
let _e609 = global_1.member.member_8.member_2;
let _e613 = global_1.member.member_8.member_6;
let _e620 = global_1.member.member_8.member_4;
let _e622 = ((_e609 + (_e613 * _e605)) + (((_e592 - _e581) + 0.5f) * _e620));
let _e626 = global_1.member.member_8.member_3;
let _e630 = global_1.member.member_8.member_7;
let _e635 = ((_e626 + (_e630 * _e605)) + (((_e594 - _e590) + 0.5f) * _e620));
let _e639 = global_1.member.member_5.member_1;
let _e640 = (_e639 - _e604);
let _e645 = ((_e609 + (_e613 * _e640)) + ((_e592 + 0.5f) * _e620));
let _e650 = ((_e626 + (_e630 * _e640)) + ((_e594 + 0.5f) * _e620));
let _e654 = global_1.member.member_6.member;
let _e665 = ((((_e654.member.member * _e622) + (_e654.member.member_1 * _e635)) + (_e654.member.member_2 * _e600)) + _e654.member_1);
let _e669 = global_1.member.member_6.member_1;
let _e680 = ((((_e669.member.member * _e622) + (_e669.member.member_1 * _e635)) + (_e669.member.member_2 * _e600)) + _e669.member_1);
let _e684 = global_1.member.member_6.member_2;
let _e695 = ((((_e684.member.member * _e622) + (_e684.member.member_1 * _e635)) + (_e684.member.member_2 * _e600)) + _e684.member_1);
let _e701 = ((((_e654.member.member * _e645) + (_e654.member.member_1 * _e650)) + (_e654.member.member_2 * _e639)) + _e654.member_1);
let _e707 = ((((_e669.member.member * _e645) + (_e669.member.member_1 * _e650)) + (_e669.member.member_2 * _e639)) + _e669.member_1);
let _e713 = ((((_e684.member.member * _e645) + (_e684.member.member_1 * _e650)) + (_e684.member.member_2 * _e639)) + _e684.member_1);
let _e715 = (_e102.member_2 == 2u);
let _e718 = (((_e102.member_2 == 1u) || _e715) || (_e102.member_2 == 5u));
if _e718 {
let _e723 = global_1.member.member_6.member_3.member;
let _e724 = (_e723 - 0.5f);
let _e726 = select(-0.5f, _e701, (_e701 > -0.5f));
let _e728 = select(_e724, _e726, (_e726 < _e724));
let _e733 = global_1.member.member_6.member_3.member_1;
let _e734 = (_e733 - 0.5f);
let _e736 = select(-0.5f, _e707, (_e707 > -0.5f));
let _e738 = select(_e734, _e736, (_e736 < _e734));
let _e743 = global_1.member.member_6.member_3.member_2;
let _e744 = (_e743 - 0.5f);
let _e746 = select(-0.5f, _e713, (_e713 > -0.5f));
let _e748 = select(_e744, _e746, (_e746 < _e744));
let _e750 = select(-1f, _e728, (_e728 > -1f));
let _e752 = select(_e723, _e750, (_e750 < _e723));
let _e759 = select(0i, select(select(i32(_e752), i32(-2147483648), (_e752 < -2147483600f)), 2147483647i, (_e752 > 2147483500f)), (_e752 == _e752));
let _e763 = (_e759 - select(0i, 1i, (_e752 < f32(_e759))));
let _e765 = select(-1f, _e738, (_e738 > -1f));
let _e767 = select(_e733, _e765, (_e765 < _e733));
let _e774 = select(0i, select(select(i32(_e767), i32(-2147483648), (_e767 < -2147483600f)), 2147483647i, (_e767 > 2147483500f)), (_e767 == _e767));
let _e778 = (_e774 - select(0i, 1i, (_e767 < f32(_e774))));
let _e780 = select(-1f, _e748, (_e748 > -1f));
let _e782 = select(_e743, _e780, (_e780 < _e743));
let _e789 = select(0i, select(select(i32(_e782), i32(-2147483648), (_e782 < -2147483600f)), 2147483647i, (_e782 > 2147483500f)), (_e782 == _e782));
let _e793 = (_e789 - select(0i, 1i, (_e782 < f32(_e789))));
let _e797 = global_1.member.member_6.member_7;
let _e801 = global_1.member.member_6.member_8;
let _e809 = (select(0i, select(select(i32(_e733), i32(-2147483648), (_e733 < -2147483600f)), 2147483647i, (_e733 > 2147483500f)), (_e733 == _e733)) - 1i);
let _e810 = (_e778 - 1i);
let _e815 = (_e778 + 1i);
let _e818 = (_e778 + 2i);
let _e828 = (select(0i, select(select(i32(_e743), i32(-2147483648), (_e743 < -2147483600f)), 2147483647i, (_e743 > 2147483500f)), (_e743 == _e743)) - 1i);
let _e829 = (_e793 - 1i);
let _e834 = (_e793 + 1i);
let _e837 = (_e793 + 2i);
let _e846 = select(0i, select(select(i32(_e723), i32(-2147483648), (_e723 < -2147483600f)), 2147483647i, (_e723 > 2147483500f)), (_e723 == _e723));
let _e847 = (_e846 - 1i);
let _e848 = (_e763 - 1i);
let _e850 = select(0i, _e848, (_e848 > 0i));
let _e853 = (_e763 + 1i);
let _e856 = (_e763 + 2i);
let _e859 = (_e846 - 4i);
let _e861 = select(0i, _e859, (_e859 > 0i));
let _e863 = select(_e861, _e850, (_e850 < _e861));
let _e876 = (select(0i, _e810, (_e810 > 0i)) * _e797);
let _e877 = (select(0i, _e778, (_e778 > 0i)) * _e797);
let _e878 = (select(_e809, _e815, (_e815 < _e809)) * _e797);
let _e879 = (select(_e809, _e818, (_e818 < _e809)) * _e797);
let _e880 = (select(0i, _e829, (_e829 > 0i)) * _e801);
let _e881 = (select(0i, _e793, (_e793 > 0i)) * _e801);
let _e882 = (select(_e828, _e834, (_e834 < _e828)) * _e801);
let _e883 = (select(_e828, _e837, (_e837 < _e828)) * _e801);
local_4 = type_28(array<i32, 4>(_e863, _e863, _e863, _e863), array<u32, 6>(bitcast<u32>(((_e850 - _e863) * 8i)), bitcast<u32>(((select(0i, _e763, (_e763 > 0i)) - _e863) * 8i)), bitcast<u32>(((select(_e847, _e853, (_e853 < _e847)) - _e863) * 8i)), bitcast<u32>(((select(_e847, _e856, (_e856 < _e847)) - _e863) * 8i)), 0u, 0u));
local_5 = vec3<f32>((_e728 - f32(_e763)), (_e738 - f32(_e778)), (_e748 - f32(_e793)));
let _e898 = local_4.member[0u];
let _e899 = ((_e881 + _e877) + _e898);
let _e901 = (_e899 >> bitcast<u32>(2i));
let _e904 = bitcast<u32>(((_e899 & 3i) * 8i));
let _e906 = (bitcast<i32>(_e88) - 1i);
let _e908 = select(_e906, _e901, (_e901 < _e906));
let _e913 = global_2.member[bitcast<u32>(select(0i, _e908, (_e908 > 0i)))];
let _e917 = (_e901 + 1i);
let _e919 = select(_e906, _e917, (_e917 < _e906));
let _e924 = global_2.member[bitcast<u32>(select(0i, _e919, (_e919 > 0i)))];
let _e931 = ((_e913 >> bitcast<u32>((_e904 & 31u))) | ((_e924 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e904) & 31u))));
let _e934 = local_4.member_1[0u];
let _e940 = f32(bitcast<i32>(((_e931 >> bitcast<u32>((_e934 & 31u))) & 255u)));
let _e943 = local_4.member_1[1u];
let _e949 = f32(bitcast<i32>(((_e931 >> bitcast<u32>((_e943 & 31u))) & 255u)));
let _e952 = local_4.member_1[2u];
let _e958 = f32(bitcast<i32>(((_e931 >> bitcast<u32>((_e952 & 31u))) & 255u)));
let _e961 = local_4.member_1[3u];
let _e968 = local_5[0u];
let _e971 = (_e940 + ((_e949 - _e940) * _e968));
let _e972 = local_5[0u];
let _e975 = (_e949 + ((_e958 - _e949) * _e972));
let _e976 = local_5[0u];
let _e979 = (_e958 + ((f32(bitcast<i32>(((_e931 >> bitcast<u32>((_e961 & 31u))) & 255u))) - _e958) * _e976));
let _e981 = local_4.member[0u];
let _e982 = ((_e881 + _e878) + _e981);
let _e984 = (_e982 >> bitcast<u32>(2i));
let _e987 = bitcast<u32>(((_e982 & 3i) * 8i));
let _e989 = select(_e906, _e984, (_e984 < _e906));
let _e994 = global_2.member[bitcast<u32>(select(0i, _e989, (_e989 > 0i)))];
let _e998 = (_e984 + 1i);
let _e1000 = select(_e906, _e998, (_e998 < _e906));
let _e1005 = global_2.member[bitcast<u32>(select(0i, _e1000, (_e1000 > 0i)))];
let _e1012 = ((_e994 >> bitcast<u32>((_e987 & 31u))) | ((_e1005 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e987) & 31u))));
let _e1013 = local_4.member_1[0u];
let _e1019 = f32(bitcast<i32>(((_e1012 >> bitcast<u32>((_e1013 & 31u))) & 255u)));
let _e1020 = local_4.member_1[1u];
let _e1026 = f32(bitcast<i32>(((_e1012 >> bitcast<u32>((_e1020 & 31u))) & 255u)));
let _e1027 = local_4.member_1[2u];
let _e1033 = f32(bitcast<i32>(((_e1012 >> bitcast<u32>((_e1027 & 31u))) & 255u)));
let _e1034 = local_4.member_1[3u];
let _e1041 = local_5[0u];
let _e1045 = local_5[0u];
let _e1048 = (_e1026 + ((_e1033 - _e1026) * _e1045));
let _e1049 = local_5[0u];
let _e1054 = local_4.member[0u];
let _e1055 = ((_e882 + _e877) + _e1054);
let _e1057 = (_e1055 >> bitcast<u32>(2i));
let _e1060 = bitcast<u32>(((_e1055 & 3i) * 8i));
let _e1062 = select(_e906, _e1057, (_e1057 < _e906));
let _e1067 = global_2.member[bitcast<u32>(select(0i, _e1062, (_e1062 > 0i)))];
let _e1071 = (_e1057 + 1i);
let _e1073 = select(_e906, _e1071, (_e1071 < _e906));
let _e1078 = global_2.member[bitcast<u32>(select(0i, _e1073, (_e1073 > 0i)))];
let _e1085 = ((_e1067 >> bitcast<u32>((_e1060 & 31u))) | ((_e1078 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1060) & 31u))));
let _e1086 = local_4.member_1[0u];
let _e1092 = f32(bitcast<i32>(((_e1085 >> bitcast<u32>((_e1086 & 31u))) & 255u)));
let _e1093 = local_4.member_1[1u];
let _e1099 = f32(bitcast<i32>(((_e1085 >> bitcast<u32>((_e1093 & 31u))) & 255u)));
let _e1100 = local_4.member_1[2u];
let _e1106 = f32(bitcast<i32>(((_e1085 >> bitcast<u32>((_e1100 & 31u))) & 255u)));
let _e1107 = local_4.member_1[3u];
let _e1114 = local_5[0u];
let _e1117 = (_e1092 + ((_e1099 - _e1092) * _e1114));
let _e1118 = local_5[0u];
let _e1121 = (_e1099 + ((_e1106 - _e1099) * _e1118));
let _e1122 = local_5[0u];
let _e1125 = (_e1106 + ((f32(bitcast<i32>(((_e1085 >> bitcast<u32>((_e1107 & 31u))) & 255u))) - _e1106) * _e1122));
let _e1127 = local_4.member[0u];
let _e1128 = ((_e882 + _e878) + _e1127);
let _e1130 = (_e1128 >> bitcast<u32>(2i));
let _e1133 = bitcast<u32>(((_e1128 & 3i) * 8i));
let _e1135 = select(_e906, _e1130, (_e1130 < _e906));
let _e1140 = global_2.member[bitcast<u32>(select(0i, _e1135, (_e1135 > 0i)))];
let _e1144 = (_e1130 + 1i);
let _e1146 = select(_e906, _e1144, (_e1144 < _e906));
let _e1151 = global_2.member[bitcast<u32>(select(0i, _e1146, (_e1146 > 0i)))];
let _e1158 = ((_e1140 >> bitcast<u32>((_e1133 & 31u))) | ((_e1151 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1133) & 31u))));
let _e1159 = local_4.member_1[0u];
let _e1165 = f32(bitcast<i32>(((_e1158 >> bitcast<u32>((_e1159 & 31u))) & 255u)));
let _e1166 = local_4.member_1[1u];
let _e1172 = f32(bitcast<i32>(((_e1158 >> bitcast<u32>((_e1166 & 31u))) & 255u)));
let _e1173 = local_4.member_1[2u];
let _e1179 = f32(bitcast<i32>(((_e1158 >> bitcast<u32>((_e1173 & 31u))) & 255u)));
let _e1180 = local_4.member_1[3u];
let _e1187 = local_5[0u];
let _e1191 = local_5[0u];
let _e1194 = (_e1172 + ((_e1179 - _e1172) * _e1191));
let _e1195 = local_5[0u];
let _e1200 = local_4.member[0u];
let _e1201 = ((_e881 + _e876) + _e1200);
let _e1203 = (_e1201 >> bitcast<u32>(2i));
let _e1206 = bitcast<u32>(((_e1201 & 3i) * 8i));
let _e1208 = select(_e906, _e1203, (_e1203 < _e906));
let _e1213 = global_2.member[bitcast<u32>(select(0i, _e1208, (_e1208 > 0i)))];
let _e1217 = (_e1203 + 1i);
let _e1219 = select(_e906, _e1217, (_e1217 < _e906));
let _e1224 = global_2.member[bitcast<u32>(select(0i, _e1219, (_e1219 > 0i)))];
let _e1231 = ((_e1213 >> bitcast<u32>((_e1206 & 31u))) | ((_e1224 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1206) & 31u))));
let _e1232 = local_4.member_1[1u];
let _e1238 = f32(bitcast<i32>(((_e1231 >> bitcast<u32>((_e1232 & 31u))) & 255u)));
let _e1239 = local_4.member_1[2u];
let _e1246 = local_5[0u];
let _e1249 = (_e1238 + ((f32(bitcast<i32>(((_e1231 >> bitcast<u32>((_e1239 & 31u))) & 255u))) - _e1238) * _e1246));
let _e1251 = local_4.member[0u];
let _e1252 = ((_e881 + _e879) + _e1251);
let _e1254 = (_e1252 >> bitcast<u32>(2i));
let _e1257 = bitcast<u32>(((_e1252 & 3i) * 8i));
let _e1259 = select(_e906, _e1254, (_e1254 < _e906));
let _e1264 = global_2.member[bitcast<u32>(select(0i, _e1259, (_e1259 > 0i)))];
let _e1268 = (_e1254 + 1i);
let _e1270 = select(_e906, _e1268, (_e1268 < _e906));
let _e1275 = global_2.member[bitcast<u32>(select(0i, _e1270, (_e1270 > 0i)))];
let _e1282 = ((_e1264 >> bitcast<u32>((_e1257 & 31u))) | ((_e1275 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1257) & 31u))));
let _e1283 = local_4.member_1[1u];
let _e1289 = f32(bitcast<i32>(((_e1282 >> bitcast<u32>((_e1283 & 31u))) & 255u)));
let _e1290 = local_4.member_1[2u];
let _e1297 = local_5[0u];
let _e1302 = local_4.member[0u];
let _e1303 = ((_e882 + _e876) + _e1302);
let _e1305 = (_e1303 >> bitcast<u32>(2i));
let _e1308 = bitcast<u32>(((_e1303 & 3i) * 8i));
let _e1310 = select(_e906, _e1305, (_e1305 < _e906));
let _e1315 = global_2.member[bitcast<u32>(select(0i, _e1310, (_e1310 > 0i)))];
let _e1319 = (_e1305 + 1i);
let _e1321 = select(_e906, _e1319, (_e1319 < _e906));
let _e1326 = global_2.member[bitcast<u32>(select(0i, _e1321, (_e1321 > 0i)))];
let _e1333 = ((_e1315 >> bitcast<u32>((_e1308 & 31u))) | ((_e1326 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1308) & 31u))));
let _e1334 = local_4.member_1[1u];
let _e1340 = f32(bitcast<i32>(((_e1333 >> bitcast<u32>((_e1334 & 31u))) & 255u)));
let _e1341 = local_4.member_1[2u];
let _e1348 = local_5[0u];
let _e1351 = (_e1340 + ((f32(bitcast<i32>(((_e1333 >> bitcast<u32>((_e1341 & 31u))) & 255u))) - _e1340) * _e1348));
let _e1353 = local_4.member[0u];
let _e1354 = ((_e882 + _e879) + _e1353);
let _e1356 = (_e1354 >> bitcast<u32>(2i));
let _e1359 = bitcast<u32>(((_e1354 & 3i) * 8i));
let _e1361 = select(_e906, _e1356, (_e1356 < _e906));
let _e1366 = global_2.member[bitcast<u32>(select(0i, _e1361, (_e1361 > 0i)))];
let _e1370 = (_e1356 + 1i);
let _e1372 = select(_e906, _e1370, (_e1370 < _e906));
let _e1377 = global_2.member[bitcast<u32>(select(0i, _e1372, (_e1372 > 0i)))];
let _e1384 = ((_e1366 >> bitcast<u32>((_e1359 & 31u))) | ((_e1377 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1359) & 31u))));
let _e1385 = local_4.member_1[1u];
let _e1391 = f32(bitcast<i32>(((_e1384 >> bitcast<u32>((_e1385 & 31u))) & 255u)));
let _e1392 = local_4.member_1[2u];
let _e1399 = local_5[0u];
let _e1404 = local_4.member[0u];
let _e1405 = ((_e880 + _e877) + _e1404);
let _e1407 = (_e1405 >> bitcast<u32>(2i));
let _e1410 = bitcast<u32>(((_e1405 & 3i) * 8i));
let _e1412 = select(_e906, _e1407, (_e1407 < _e906));
let _e1417 = global_2.member[bitcast<u32>(select(0i, _e1412, (_e1412 > 0i)))];
let _e1421 = (_e1407 + 1i);
let _e1423 = select(_e906, _e1421, (_e1421 < _e906));
let _e1428 = global_2.member[bitcast<u32>(select(0i, _e1423, (_e1423 > 0i)))];
let _e1435 = ((_e1417 >> bitcast<u32>((_e1410 & 31u))) | ((_e1428 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1410) & 31u))));
let _e1436 = local_4.member_1[1u];
let _e1442 = f32(bitcast<i32>(((_e1435 >> bitcast<u32>((_e1436 & 31u))) & 255u)));
let _e1443 = local_4.member_1[2u];
let _e1450 = local_5[0u];
let _e1453 = (_e1442 + ((f32(bitcast<i32>(((_e1435 >> bitcast<u32>((_e1443 & 31u))) & 255u))) - _e1442) * _e1450));
let _e1455 = local_4.member[0u];
let _e1456 = ((_e883 + _e877) + _e1455);
let _e1458 = (_e1456 >> bitcast<u32>(2i));
let _e1461 = bitcast<u32>(((_e1456 & 3i) * 8i));
let _e1463 = select(_e906, _e1458, (_e1458 < _e906));
let _e1468 = global_2.member[bitcast<u32>(select(0i, _e1463, (_e1463 > 0i)))];
let _e1472 = (_e1458 + 1i);
let _e1474 = select(_e906, _e1472, (_e1472 < _e906));
let _e1479 = global_2.member[bitcast<u32>(select(0i, _e1474, (_e1474 > 0i)))];
let _e1486 = ((_e1468 >> bitcast<u32>((_e1461 & 31u))) | ((_e1479 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1461) & 31u))));
let _e1487 = local_4.member_1[1u];
let _e1493 = f32(bitcast<i32>(((_e1486 >> bitcast<u32>((_e1487 & 31u))) & 255u)));
let _e1494 = local_4.member_1[2u];
let _e1501 = local_5[0u];
let _e1504 = (_e1493 + ((f32(bitcast<i32>(((_e1486 >> bitcast<u32>((_e1494 & 31u))) & 255u))) - _e1493) * _e1501));
let _e1506 = local_4.member[0u];
let _e1507 = ((_e880 + _e878) + _e1506);
let _e1509 = (_e1507 >> bitcast<u32>(2i));
let _e1512 = bitcast<u32>(((_e1507 & 3i) * 8i));
let _e1514 = select(_e906, _e1509, (_e1509 < _e906));
let _e1519 = global_2.member[bitcast<u32>(select(0i, _e1514, (_e1514 > 0i)))];
let _e1523 = (_e1509 + 1i);
let _e1525 = select(_e906, _e1523, (_e1523 < _e906));
let _e1530 = global_2.member[bitcast<u32>(select(0i, _e1525, (_e1525 > 0i)))];
let _e1537 = ((_e1519 >> bitcast<u32>((_e1512 & 31u))) | ((_e1530 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1512) & 31u))));
let _e1538 = local_4.member_1[1u];
let _e1544 = f32(bitcast<i32>(((_e1537 >> bitcast<u32>((_e1538 & 31u))) & 255u)));
let _e1545 = local_4.member_1[2u];
let _e1552 = local_5[0u];
let _e1557 = local_4.member[0u];
let _e1558 = ((_e883 + _e878) + _e1557);
let _e1560 = (_e1558 >> bitcast<u32>(2i));
let _e1563 = bitcast<u32>(((_e1558 & 3i) * 8i));
let _e1565 = select(_e906, _e1560, (_e1560 < _e906));
let _e1570 = global_2.member[bitcast<u32>(select(0i, _e1565, (_e1565 > 0i)))];
let _e1574 = (_e1560 + 1i);
let _e1576 = select(_e906, _e1574, (_e1574 < _e906));
let _e1581 = global_2.member[bitcast<u32>(select(0i, _e1576, (_e1576 > 0i)))];
let _e1588 = ((_e1570 >> bitcast<u32>((_e1563 & 31u))) | ((_e1581 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1563) & 31u))));
let _e1589 = local_4.member_1[1u];
let _e1595 = f32(bitcast<i32>(((_e1588 >> bitcast<u32>((_e1589 & 31u))) & 255u)));
let _e1596 = local_4.member_1[2u];
let _e1603 = local_5[0u];
let _e1608 = local_5[1u];
let _e1611 = (_e975 + ((_e1048 - _e975) * _e1608));
let _e1612 = local_5[1u];
let _e1615 = (_e1121 + ((_e1194 - _e1121) * _e1612));
let _e1616 = local_5[1u];
let _e1619 = (_e971 + (((_e1019 + ((_e1026 - _e1019) * _e1041)) - _e971) * _e1616));
let _e1620 = local_5[1u];
let _e1625 = local_5[2u];
let _e1629 = local_5[1u];
let _e1632 = (_e979 + (((_e1033 + ((f32(bitcast<i32>(((_e1012 >> bitcast<u32>((_e1034 & 31u))) & 255u))) - _e1033) * _e1049)) - _e979) * _e1629));
let _e1633 = local_5[1u];
let _e1637 = local_5[2u];
let _e1641 = local_5[1u];
let _e1644 = (_e1249 + ((_e975 - _e1249) * _e1641));
let _e1645 = local_5[1u];
let _e1649 = local_5[2u];
let _e1653 = local_5[1u];
let _e1656 = (_e1048 + (((_e1289 + ((f32(bitcast<i32>(((_e1282 >> bitcast<u32>((_e1290 & 31u))) & 255u))) - _e1289) * _e1297)) - _e1048) * _e1653));
let _e1657 = local_5[1u];
let _e1661 = local_5[2u];
let _e1665 = local_5[1u];
let _e1668 = (_e1453 + (((_e1544 + ((f32(bitcast<i32>(((_e1537 >> bitcast<u32>((_e1545 & 31u))) & 255u))) - _e1544) * _e1552)) - _e1453) * _e1665));
let _e1669 = local_5[2u];
let _e1673 = local_5[1u];
let _e1677 = local_5[2u];
let _e1681 = local_5[2u];
let _e1688 = global_1.member.member_6.member_5;
let _e1693 = global_1.member.member_6.member_6;
let _e1694 = (((_e1611 + ((_e1615 - _e1611) * _e1681)) * _e1688) + _e1693);
let _e1696 = select(0f, _e1694, (_e1694 > 0f));
let _e1698 = select(1f, _e1696, (_e1696 < 1f));
let _e1700 = (((_e1619 + (((_e1117 + (((_e1165 + ((_e1172 - _e1165) * _e1187)) - _e1117) * _e1620)) - _e1619) * _e1625)) * _e1688) + _e1693);
let _e1702 = select(0f, _e1700, (_e1700 > 0f));
let _e1704 = select(1f, _e1702, (_e1702 < 1f));
let _e1706 = (((_e1632 + (((_e1125 + (((_e1179 + ((f32(bitcast<i32>(((_e1158 >> bitcast<u32>((_e1180 & 31u))) & 255u))) - _e1179) * _e1195)) - _e1125) * _e1633)) - _e1632) * _e1637)) * _e1688) + _e1693);
let _e1708 = select(0f, _e1706, (_e1706 > 0f));
let _e1710 = select(1f, _e1708, (_e1708 < 1f));
let _e1712 = (((_e1644 + (((_e1351 + ((_e1121 - _e1351) * _e1645)) - _e1644) * _e1649)) * _e1688) + _e1693);
let _e1714 = select(0f, _e1712, (_e1712 > 0f));
let _e1716 = select(1f, _e1714, (_e1714 < 1f));
let _e1718 = (((_e1656 + (((_e1194 + (((_e1391 + ((f32(bitcast<i32>(((_e1384 >> bitcast<u32>((_e1392 & 31u))) & 255u))) - _e1391) * _e1399)) - _e1194) * _e1657)) - _e1656) * _e1661)) * _e1688) + _e1693);
let _e1720 = select(0f, _e1718, (_e1718 > 0f));
let _e1722 = select(1f, _e1720, (_e1720 < 1f));
let _e1724 = (((_e1668 + ((_e1611 - _e1668) * _e1669)) * _e1688) + _e1693);
let _e1726 = select(0f, _e1724, (_e1724 > 0f));
let _e1728 = select(1f, _e1726, (_e1726 < 1f));
let _e1730 = (((_e1615 + (((_e1504 + (((_e1595 + ((f32(bitcast<i32>(((_e1588 >> bitcast<u32>((_e1596 & 31u))) & 255u))) - _e1595) * _e1603)) - _e1504) * _e1673)) - _e1615) * _e1677)) * _e1688) + _e1693);
let _e1732 = select(0f, _e1730, (_e1730 > 0f));
let _e1734 = select(1f, _e1732, (_e1732 < 1f));
let _e1735 = (_e1698 * 1024f);
let _e1736 = (1024f - 1f);
let _e1738 = select(0f, _e1735, (_e1735 > 0f));
let _e1740 = select(_e1736, _e1738, (_e1738 < _e1736));
let _e1747 = select(0i, select(select(i32(_e1740), i32(-2147483648), (_e1740 < -2147483600f)), 2147483647i, (_e1740 > 2147483500f)), (_e1740 == _e1740));
let _e1751 = (_e1747 - select(0i, 1i, (_e1740 < f32(_e1747))));
let _e1752 = (262147i + _e1751);
let _e1754 = (bitcast<i32>(_e92) - 1i);
let _e1756 = select(_e1754, _e1752, (_e1752 < _e1754));
let _e1762 = global_4.member[bitcast<u32>(select(0i, _e1756, (_e1756 > 0i)))];
let _e1772 = select(_e1754, 262146i, (262146i < _e1754));
let _e1778 = global_4.member[bitcast<u32>(select(0i, _e1772, (_e1772 > 0i)))];
let _e1779 = bitcast<f32>(_e1778);
let _e1780 = (f32((bitcast<i32>((_e1762 & 4095u)) - 2048i)) * _e1779);
let _e1782 = select(_e1754, 262144i, (262144i < _e1754));
let _e1788 = global_4.member[bitcast<u32>(select(0i, _e1782, (_e1782 > 0i)))];
let _e1789 = bitcast<f32>(_e1788);
let _e1791 = select(_e1754, 262145i, (262145i < _e1754));
let _e1797 = global_4.member[bitcast<u32>(select(0i, _e1791, (_e1791 > 0i)))];
let _e1798 = bitcast<f32>(_e1797);
let _e1804 = ((_e1789 + (f32(bitcast<i32>((_e1762 >> bitcast<u32>(12u)))) * _e1798)) + (_e1780 * (_e1735 - f32(_e1751))));
let _e1805 = (_e1780 * 1024f);
if _e715 {
let _e1812 = ((0.5f * (_e1710 - _e1704)) * _e1805);
let _e1813 = ((0.5f * (_e1722 - _e1716)) * _e1805);
let _e1814 = ((0.5f * (_e1734 - _e1728)) * _e1805);
phi_3406_ = type_29(_e1804, vec3<f32>(_e1812, _e1813, _e1814), vec3<f32>((_e1812 * _e1804), (_e1813 * _e1804), (_e1814 * _e1804)));
} else {
let _e1821 = (_e1704 * 1024f);
let _e1823 = select(0f, _e1821, (_e1821 > 0f));
let _e1825 = select(_e1736, _e1823, (_e1823 < _e1736));
let _e1832 = select(0i, select(select(i32(_e1825), i32(-2147483648), (_e1825 < -2147483600f)), 2147483647i, (_e1825 > 2147483500f)), (_e1825 == _e1825));
let _e1836 = (_e1832 - select(0i, 1i, (_e1825 < f32(_e1832))));
let _e1837 = (262147i + _e1836);
let _e1839 = select(_e1754, _e1837, (_e1837 < _e1754));
let _e1845 = global_4.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1860 = ((_e1789 + (f32(bitcast<i32>((_e1845 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e1845 & 4095u)) - 2048i)) * _e1779) * (_e1821 - f32(_e1836))));
let _e1861 = (_e1710 * 1024f);
let _e1863 = select(0f, _e1861, (_e1861 > 0f));
let _e1865 = select(_e1736, _e1863, (_e1863 < _e1736));
let _e1872 = select(0i, select(select(i32(_e1865), i32(-2147483648), (_e1865 < -2147483600f)), 2147483647i, (_e1865 > 2147483500f)), (_e1865 == _e1865));
let _e1876 = (_e1872 - select(0i, 1i, (_e1865 < f32(_e1872))));
let _e1877 = (262147i + _e1876);
let _e1879 = select(_e1754, _e1877, (_e1877 < _e1754));
let _e1885 = global_4.member[bitcast<u32>(select(0i, _e1879, (_e1879 > 0i)))];
let _e1900 = ((_e1789 + (f32(bitcast<i32>((_e1885 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e1885 & 4095u)) - 2048i)) * _e1779) * (_e1861 - f32(_e1876))));
let _e1901 = (_e1716 * 1024f);
let _e1903 = select(0f, _e1901, (_e1901 > 0f));
let _e1905 = select(_e1736, _e1903, (_e1903 < _e1736));
let _e1912 = select(0i, select(select(i32(_e1905), i32(-2147483648), (_e1905 < -2147483600f)), 2147483647i, (_e1905 > 2147483500f)), (_e1905 == _e1905));
let _e1916 = (_e1912 - select(0i, 1i, (_e1905 < f32(_e1912))));
let _e1917 = (262147i + _e1916);
let _e1919 = select(_e1754, _e1917, (_e1917 < _e1754));
let _e1925 = global_4.member[bitcast<u32>(select(0i, _e1919, (_e1919 > 0i)))];
let _e1940 = ((_e1789 + (f32(bitcast<i32>((_e1925 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e1925 & 4095u)) - 2048i)) * _e1779) * (_e1901 - f32(_e1916))));
let _e1941 = (_e1722 * 1024f);
let _e1943 = select(0f, _e1941, (_e1941 > 0f));
let _e1945 = select(_e1736, _e1943, (_e1943 < _e1736));
let _e1952 = select(0i, select(select(i32(_e1945), i32(-2147483648), (_e1945 < -2147483600f)), 2147483647i, (_e1945 > 2147483500f)), (_e1945 == _e1945));
let _e1956 = (_e1952 - select(0i, 1i, (_e1945 < f32(_e1952))));
let _e1957 = (262147i + _e1956);
let _e1959 = select(_e1754, _e1957, (_e1957 < _e1754));
let _e1965 = global_4.member[bitcast<u32>(select(0i, _e1959, (_e1959 > 0i)))];
let _e1980 = ((_e1789 + (f32(bitcast<i32>((_e1965 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e1965 & 4095u)) - 2048i)) * _e1779) * (_e1941 - f32(_e1956))));
let _e1981 = (_e1728 * 1024f);
let _e1983 = select(0f, _e1981, (_e1981 > 0f));
let _e1985 = select(_e1736, _e1983, (_e1983 < _e1736));
let _e1992 = select(0i, select(select(i32(_e1985), i32(-2147483648), (_e1985 < -2147483600f)), 2147483647i, (_e1985 > 2147483500f)), (_e1985 == _e1985));
let _e1996 = (_e1992 - select(0i, 1i, (_e1985 < f32(_e1992))));
let _e1997 = (262147i + _e1996);
let _e1999 = select(_e1754, _e1997, (_e1997 < _e1754));
let _e2005 = global_4.member[bitcast<u32>(select(0i, _e1999, (_e1999 > 0i)))];
let _e2020 = ((_e1789 + (f32(bitcast<i32>((_e2005 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e2005 & 4095u)) - 2048i)) * _e1779) * (_e1981 - f32(_e1996))));
let _e2021 = (_e1734 * 1024f);
let _e2023 = select(0f, _e2021, (_e2021 > 0f));
let _e2025 = select(_e1736, _e2023, (_e2023 < _e1736));
let _e2032 = select(0i, select(select(i32(_e2025), i32(-2147483648), (_e2025 < -2147483600f)), 2147483647i, (_e2025 > 2147483500f)), (_e2025 == _e2025));
let _e2036 = (_e2032 - select(0i, 1i, (_e2025 < f32(_e2032))));
let _e2037 = (262147i + _e2036);
let _e2039 = select(_e1754, _e2037, (_e2037 < _e1754));
let _e2045 = global_4.member[bitcast<u32>(select(0i, _e2039, (_e2039 > 0i)))];
let _e2060 = ((_e1789 + (f32(bitcast<i32>((_e2045 >> bitcast<u32>(12u)))) * _e1798)) + ((f32((bitcast<i32>((_e2045 & 4095u)) - 2048i)) * _e1779) * (_e2021 - f32(_e2036))));
let _e2061 = (_e1900 - _e1860);
let _e2063 = (_e1980 - _e1940);
let _e2065 = (_e2060 - _e2020);
phi_3406_ = type_29(_e1804, vec3<f32>((0.5f * _e2061), (0.5f * _e2063), (0.5f * _e2065)), vec3<f32>((0.25f * (_e2061 * (_e1900 + _e1860))), (0.25f * (_e2063 * (_e1980 + _e1940))), (0.25f * (_e2065 * (_e2060 + _e2020)))));
}
let _e2080 = phi_3406_;
let _e2095 = select(0f, 1f, ((((((_e701 >= -0.5f) && (_e701 <= _e724)) && (_e707 >= -0.5f)) && (_e707 <= _e734)) && (_e713 >= -0.5f)) && (_e713 <= _e744)));
let _e2097 = (0.5f * (_e1710 - _e1704));
let _e2099 = (0.5f * (_e1722 - _e1716));
let _e2101 = (0.5f * (_e1734 - _e1728));
let _e2107 = global_1.member.member_6.member.member.member;
let _e2113 = global_1.member.member_6.member.member.member_1;
let _e2119 = global_1.member.member_6.member.member.member_2;
let _e2125 = global_1.member.member_6.member_1.member.member;
let _e2131 = global_1.member.member_6.member_1.member.member_1;
let _e2137 = global_1.member.member_6.member_1.member.member_2;
let _e2143 = global_1.member.member_6.member_2.member.member;
let _e2149 = global_1.member.member_6.member_2.member.member_1;
let _e2155 = global_1.member.member_6.member_2.member.member_2;
phi_4168_ = type_30(_e1698, vec3<f32>(((((_e2107 * _e2097) + (_e2125 * _e2099)) + (_e2143 * _e2101)) * _e2095), ((((_e2113 * _e2097) + (_e2131 * _e2099)) + (_e2149 * _e2101)) * _e2095), ((((_e2119 * _e2097) + (_e2137 * _e2099)) + (_e2155 * _e2101)) * _e2095)), _e2080.member, vec3<f32>(((((_e2107 * _e2080.member_2.x) + (_e2125 * _e2080.member_2.y)) + (_e2143 * _e2080.member_2.z)) * _e2095), ((((_e2113 * _e2080.member_2.x) + (_e2131 * _e2080.member_2.y)) + (_e2149 * _e2080.member_2.z)) * _e2095), ((((_e2119 * _e2080.member_2.x) + (_e2137 * _e2080.member_2.y)) + (_e2155 * _e2080.member_2.z)) * _e2095)), vec3<f32>(((((_e2107 * _e2080.member_1.x) + (_e2125 * _e2080.member_1.y)) + (_e2143 * _e2080.member_1.z)) * _e2095), ((((_e2113 * _e2080.member_1.x) + (_e2131 * _e2080.member_1.y)) + (_e2149 * _e2080.member_1.z)) * _e2095), ((((_e2119 * _e2080.member_1.x) + (_e2137 * _e2080.member_1.y)) + (_e2155 * _e2080.member_1.z)) * _e2095)));
} else {
let _e2224 = global_1.member.member_6.member_3.member;
let _e2225 = (_e2224 - 0.5f);
let _e2227 = select(-0.5f, _e701, (_e701 > -0.5f));
let _e2229 = select(_e2225, _e2227, (_e2227 < _e2225));
let _e2234 = global_1.member.member_6.member_3.member_1;
let _e2235 = (_e2234 - 0.5f);
let _e2237 = select(-0.5f, _e707, (_e707 > -0.5f));
let _e2239 = select(_e2235, _e2237, (_e2237 < _e2235));
let _e2244 = global_1.member.member_6.member_3.member_2;
let _e2245 = (_e2244 - 0.5f);
let _e2247 = select(-0.5f, _e713, (_e713 > -0.5f));
let _e2249 = select(_e2245, _e2247, (_e2247 < _e2245));
let _e2251 = select(-1f, _e2229, (_e2229 > -1f));
let _e2253 = select(_e2224, _e2251, (_e2251 < _e2224));
let _e2260 = select(0i, select(select(i32(_e2253), i32(-2147483648), (_e2253 < -2147483600f)), 2147483647i, (_e2253 > 2147483500f)), (_e2253 == _e2253));
let _e2264 = (_e2260 - select(0i, 1i, (_e2253 < f32(_e2260))));
let _e2266 = select(-1f, _e2239, (_e2239 > -1f));
let _e2268 = select(_e2234, _e2266, (_e2266 < _e2234));
let _e2275 = select(0i, select(select(i32(_e2268), i32(-2147483648), (_e2268 < -2147483600f)), 2147483647i, (_e2268 > 2147483500f)), (_e2268 == _e2268));
let _e2279 = (_e2275 - select(0i, 1i, (_e2268 < f32(_e2275))));
let _e2281 = select(-1f, _e2249, (_e2249 > -1f));
let _e2283 = select(_e2244, _e2281, (_e2281 < _e2244));
let _e2290 = select(0i, select(select(i32(_e2283), i32(-2147483648), (_e2283 < -2147483600f)), 2147483647i, (_e2283 > 2147483500f)), (_e2283 == _e2283));
let _e2294 = (_e2290 - select(0i, 1i, (_e2283 < f32(_e2290))));
let _e2298 = global_1.member.member_6.member_7;
let _e2302 = global_1.member.member_6.member_8;
let _e2310 = (select(0i, select(select(i32(_e2234), i32(-2147483648), (_e2234 < -2147483600f)), 2147483647i, (_e2234 > 2147483500f)), (_e2234 == _e2234)) - 1i);
let _e2313 = (_e2279 + 1i);
let _e2323 = (select(0i, select(select(i32(_e2244), i32(-2147483648), (_e2244 < -2147483600f)), 2147483647i, (_e2244 > 2147483500f)), (_e2244 == _e2244)) - 1i);
let _e2326 = (_e2294 + 1i);
let _e2335 = select(0i, select(select(i32(_e2224), i32(-2147483648), (_e2224 < -2147483600f)), 2147483647i, (_e2224 > 2147483500f)), (_e2224 == _e2224));
let _e2336 = (_e2335 - 1i);
let _e2337 = (_e2264 - 1i);
let _e2339 = select(0i, _e2337, (_e2337 > 0i));
let _e2342 = (_e2264 + 1i);
let _e2345 = (_e2264 + 2i);
let _e2348 = (_e2335 - 4i);
let _e2350 = select(0i, _e2348, (_e2348 > 0i));
let _e2352 = select(_e2350, _e2339, (_e2339 < _e2350));
let _e2365 = (select(0i, _e2279, (_e2279 > 0i)) * _e2298);
let _e2366 = (select(_e2310, _e2313, (_e2313 < _e2310)) * _e2298);
let _e2367 = (select(0i, _e2294, (_e2294 > 0i)) * _e2302);
let _e2368 = (select(_e2323, _e2326, (_e2326 < _e2323)) * _e2302);
local_2 = type_28(array<i32, 4>(_e2352, _e2352, _e2352, _e2352), array<u32, 6>(bitcast<u32>(((_e2339 - _e2352) * 8i)), bitcast<u32>(((select(0i, _e2264, (_e2264 > 0i)) - _e2352) * 8i)), bitcast<u32>(((select(_e2336, _e2342, (_e2342 < _e2336)) - _e2352) * 8i)), bitcast<u32>(((select(_e2336, _e2345, (_e2345 < _e2336)) - _e2352) * 8i)), 0u, 0u));
local_3 = vec3<f32>((_e2229 - f32(_e2264)), (_e2239 - f32(_e2279)), (_e2249 - f32(_e2294)));
let _e2383 = local_2.member[0u];
let _e2384 = ((_e2367 + _e2365) + _e2383);
let _e2386 = (_e2384 >> bitcast<u32>(2i));
let _e2389 = bitcast<u32>(((_e2384 & 3i) * 8i));
let _e2391 = (bitcast<i32>(_e88) - 1i);
let _e2393 = select(_e2391, _e2386, (_e2386 < _e2391));
let _e2398 = global_2.member[bitcast<u32>(select(0i, _e2393, (_e2393 > 0i)))];
let _e2402 = (_e2386 + 1i);
let _e2404 = select(_e2391, _e2402, (_e2402 < _e2391));
let _e2409 = global_2.member[bitcast<u32>(select(0i, _e2404, (_e2404 > 0i)))];
let _e2416 = ((_e2398 >> bitcast<u32>((_e2389 & 31u))) | ((_e2409 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2389) & 31u))));
let _e2419 = local_2.member_1[1u];
let _e2425 = f32(bitcast<i32>(((_e2416 >> bitcast<u32>((_e2419 & 31u))) & 255u)));
let _e2428 = local_2.member_1[2u];
let _e2435 = local_3[0u];
let _e2438 = (_e2425 + ((f32(bitcast<i32>(((_e2416 >> bitcast<u32>((_e2428 & 31u))) & 255u))) - _e2425) * _e2435));
let _e2440 = local_2.member[0u];
let _e2441 = ((_e2367 + _e2366) + _e2440);
let _e2443 = (_e2441 >> bitcast<u32>(2i));
let _e2446 = bitcast<u32>(((_e2441 & 3i) * 8i));
let _e2448 = select(_e2391, _e2443, (_e2443 < _e2391));
let _e2453 = global_2.member[bitcast<u32>(select(0i, _e2448, (_e2448 > 0i)))];
let _e2457 = (_e2443 + 1i);
let _e2459 = select(_e2391, _e2457, (_e2457 < _e2391));
let _e2464 = global_2.member[bitcast<u32>(select(0i, _e2459, (_e2459 > 0i)))];
let _e2471 = ((_e2453 >> bitcast<u32>((_e2446 & 31u))) | ((_e2464 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2446) & 31u))));
let _e2472 = local_2.member_1[1u];
let _e2478 = f32(bitcast<i32>(((_e2471 >> bitcast<u32>((_e2472 & 31u))) & 255u)));
let _e2479 = local_2.member_1[2u];
let _e2486 = local_3[0u];
let _e2491 = local_3[1u];
let _e2494 = (_e2438 + (((_e2478 + ((f32(bitcast<i32>(((_e2471 >> bitcast<u32>((_e2479 & 31u))) & 255u))) - _e2478) * _e2486)) - _e2438) * _e2491));
let _e2496 = local_2.member[0u];
let _e2497 = ((_e2368 + _e2365) + _e2496);
let _e2499 = (_e2497 >> bitcast<u32>(2i));
let _e2502 = bitcast<u32>(((_e2497 & 3i) * 8i));
let _e2504 = select(_e2391, _e2499, (_e2499 < _e2391));
let _e2509 = global_2.member[bitcast<u32>(select(0i, _e2504, (_e2504 > 0i)))];
let _e2513 = (_e2499 + 1i);
let _e2515 = select(_e2391, _e2513, (_e2513 < _e2391));
let _e2520 = global_2.member[bitcast<u32>(select(0i, _e2515, (_e2515 > 0i)))];
let _e2527 = ((_e2509 >> bitcast<u32>((_e2502 & 31u))) | ((_e2520 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2502) & 31u))));
let _e2528 = local_2.member_1[1u];
let _e2534 = f32(bitcast<i32>(((_e2527 >> bitcast<u32>((_e2528 & 31u))) & 255u)));
let _e2535 = local_2.member_1[2u];
let _e2542 = local_3[0u];
let _e2545 = (_e2534 + ((f32(bitcast<i32>(((_e2527 >> bitcast<u32>((_e2535 & 31u))) & 255u))) - _e2534) * _e2542));
let _e2547 = local_2.member[0u];
let _e2548 = ((_e2368 + _e2366) + _e2547);
let _e2550 = (_e2548 >> bitcast<u32>(2i));
let _e2553 = bitcast<u32>(((_e2548 & 3i) * 8i));
let _e2555 = select(_e2391, _e2550, (_e2550 < _e2391));
let _e2560 = global_2.member[bitcast<u32>(select(0i, _e2555, (_e2555 > 0i)))];
let _e2564 = (_e2550 + 1i);
let _e2566 = select(_e2391, _e2564, (_e2564 < _e2391));
let _e2571 = global_2.member[bitcast<u32>(select(0i, _e2566, (_e2566 > 0i)))];
let _e2578 = ((_e2560 >> bitcast<u32>((_e2553 & 31u))) | ((_e2571 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2553) & 31u))));
let _e2579 = local_2.member_1[1u];
let _e2585 = f32(bitcast<i32>(((_e2578 >> bitcast<u32>((_e2579 & 31u))) & 255u)));
let _e2586 = local_2.member_1[2u];
let _e2593 = local_3[0u];
let _e2597 = local_3[1u];
let _e2602 = local_3[2u];
let _e2609 = global_1.member.member_6.member_5;
let _e2614 = global_1.member.member_6.member_6;
let _e2615 = (((_e2494 + (((_e2545 + (((_e2585 + ((f32(bitcast<i32>(((_e2578 >> bitcast<u32>((_e2586 & 31u))) & 255u))) - _e2585) * _e2593)) - _e2545) * _e2597)) - _e2494) * _e2602)) * _e2609) + _e2614);
let _e2617 = select(0f, _e2615, (_e2615 > 0f));
phi_4168_ = type_30(select(1f, _e2617, (_e2617 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2622 = phi_4168_;
let _e2627 = global_1.member.member_6.member_3.member;
let _e2628 = (_e2627 - 0.5f);
let _e2630 = select(-0.5f, _e665, (_e665 > -0.5f));
let _e2632 = select(_e2628, _e2630, (_e2630 < _e2628));
let _e2637 = global_1.member.member_6.member_3.member_1;
let _e2638 = (_e2637 - 0.5f);
let _e2640 = select(-0.5f, _e680, (_e680 > -0.5f));
let _e2642 = select(_e2638, _e2640, (_e2640 < _e2638));
let _e2647 = global_1.member.member_6.member_3.member_2;
let _e2648 = (_e2647 - 0.5f);
let _e2650 = select(-0.5f, _e695, (_e695 > -0.5f));
let _e2652 = select(_e2648, _e2650, (_e2650 < _e2648));
let _e2654 = select(-1f, _e2632, (_e2632 > -1f));
let _e2656 = select(_e2627, _e2654, (_e2654 < _e2627));
let _e2663 = select(0i, select(select(i32(_e2656), i32(-2147483648), (_e2656 < -2147483600f)), 2147483647i, (_e2656 > 2147483500f)), (_e2656 == _e2656));
let _e2667 = (_e2663 - select(0i, 1i, (_e2656 < f32(_e2663))));
let _e2669 = select(-1f, _e2642, (_e2642 > -1f));
let _e2671 = select(_e2637, _e2669, (_e2669 < _e2637));
let _e2678 = select(0i, select(select(i32(_e2671), i32(-2147483648), (_e2671 < -2147483600f)), 2147483647i, (_e2671 > 2147483500f)), (_e2671 == _e2671));
let _e2682 = (_e2678 - select(0i, 1i, (_e2671 < f32(_e2678))));
let _e2684 = select(-1f, _e2652, (_e2652 > -1f));
let _e2686 = select(_e2647, _e2684, (_e2684 < _e2647));
let _e2693 = select(0i, select(select(i32(_e2686), i32(-2147483648), (_e2686 < -2147483600f)), 2147483647i, (_e2686 > 2147483500f)), (_e2686 == _e2686));
let _e2697 = (_e2693 - select(0i, 1i, (_e2686 < f32(_e2693))));
let _e2701 = global_1.member.member_6.member_7;
let _e2705 = global_1.member.member_6.member_8;
let _e2713 = (select(0i, select(select(i32(_e2637), i32(-2147483648), (_e2637 < -2147483600f)), 2147483647i, (_e2637 > 2147483500f)), (_e2637 == _e2637)) - 1i);
let _e2716 = (_e2682 + 1i);
let _e2726 = (select(0i, select(select(i32(_e2647), i32(-2147483648), (_e2647 < -2147483600f)), 2147483647i, (_e2647 > 2147483500f)), (_e2647 == _e2647)) - 1i);
let _e2729 = (_e2697 + 1i);
let _e2738 = select(0i, select(select(i32(_e2627), i32(-2147483648), (_e2627 < -2147483600f)), 2147483647i, (_e2627 > 2147483500f)), (_e2627 == _e2627));
let _e2739 = (_e2738 - 1i);
let _e2740 = (_e2667 - 1i);
let _e2742 = select(0i, _e2740, (_e2740 > 0i));
let _e2745 = (_e2667 + 1i);
let _e2748 = (_e2667 + 2i);
let _e2751 = (_e2738 - 4i);
let _e2753 = select(0i, _e2751, (_e2751 > 0i));
let _e2755 = select(_e2753, _e2742, (_e2742 < _e2753));
let _e2768 = (select(0i, _e2682, (_e2682 > 0i)) * _e2701);
let _e2769 = (select(_e2713, _e2716, (_e2716 < _e2713)) * _e2701);
let _e2770 = (select(0i, _e2697, (_e2697 > 0i)) * _e2705);
let _e2771 = (select(_e2726, _e2729, (_e2729 < _e2726)) * _e2705);
local = type_28(array<i32, 4>(_e2755, _e2755, _e2755, _e2755), array<u32, 6>(bitcast<u32>(((_e2742 - _e2755) * 8i)), bitcast<u32>(((select(0i, _e2667, (_e2667 > 0i)) - _e2755) * 8i)), bitcast<u32>(((select(_e2739, _e2745, (_e2745 < _e2739)) - _e2755) * 8i)), bitcast<u32>(((select(_e2739, _e2748, (_e2748 < _e2739)) - _e2755) * 8i)), 0u, 0u));
local_1 = vec3<f32>((_e2632 - f32(_e2667)), (_e2642 - f32(_e2682)), (_e2652 - f32(_e2697)));
let _e2786 = local.member[0u];
let _e2787 = ((_e2770 + _e2768) + _e2786);
let _e2789 = (_e2787 >> bitcast<u32>(2i));
let _e2792 = bitcast<u32>(((_e2787 & 3i) * 8i));
let _e2794 = (bitcast<i32>(_e88) - 1i);
let _e2796 = select(_e2794, _e2789, (_e2789 < _e2794));
let _e2801 = global_2.member[bitcast<u32>(select(0i, _e2796, (_e2796 > 0i)))];
let _e2805 = (_e2789 + 1i);
let _e2807 = select(_e2794, _e2805, (_e2805 < _e2794));
let _e2812 = global_2.member[bitcast<u32>(select(0i, _e2807, (_e2807 > 0i)))];
let _e2819 = ((_e2801 >> bitcast<u32>((_e2792 & 31u))) | ((_e2812 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2792) & 31u))));
let _e2822 = local.member_1[1u];
let _e2828 = f32(bitcast<i32>(((_e2819 >> bitcast<u32>((_e2822 & 31u))) & 255u)));
let _e2831 = local.member_1[2u];
let _e2838 = local_1[0u];
let _e2841 = (_e2828 + ((f32(bitcast<i32>(((_e2819 >> bitcast<u32>((_e2831 & 31u))) & 255u))) - _e2828) * _e2838));
let _e2843 = local.member[0u];
let _e2844 = ((_e2770 + _e2769) + _e2843);
let _e2846 = (_e2844 >> bitcast<u32>(2i));
let _e2849 = bitcast<u32>(((_e2844 & 3i) * 8i));
let _e2851 = select(_e2794, _e2846, (_e2846 < _e2794));
let _e2856 = global_2.member[bitcast<u32>(select(0i, _e2851, (_e2851 > 0i)))];
let _e2860 = (_e2846 + 1i);
let _e2862 = select(_e2794, _e2860, (_e2860 < _e2794));
let _e2867 = global_2.member[bitcast<u32>(select(0i, _e2862, (_e2862 > 0i)))];
let _e2874 = ((_e2856 >> bitcast<u32>((_e2849 & 31u))) | ((_e2867 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2849) & 31u))));
let _e2875 = local.member_1[1u];
let _e2881 = f32(bitcast<i32>(((_e2874 >> bitcast<u32>((_e2875 & 31u))) & 255u)));
let _e2882 = local.member_1[2u];
let _e2889 = local_1[0u];
let _e2894 = local_1[1u];
let _e2897 = (_e2841 + (((_e2881 + ((f32(bitcast<i32>(((_e2874 >> bitcast<u32>((_e2882 & 31u))) & 255u))) - _e2881) * _e2889)) - _e2841) * _e2894));
let _e2899 = local.member[0u];
let _e2900 = ((_e2771 + _e2768) + _e2899);
let _e2902 = (_e2900 >> bitcast<u32>(2i));
let _e2905 = bitcast<u32>(((_e2900 & 3i) * 8i));
let _e2907 = select(_e2794, _e2902, (_e2902 < _e2794));
let _e2912 = global_2.member[bitcast<u32>(select(0i, _e2907, (_e2907 > 0i)))];
let _e2916 = (_e2902 + 1i);
let _e2918 = select(_e2794, _e2916, (_e2916 < _e2794));
let _e2923 = global_2.member[bitcast<u32>(select(0i, _e2918, (_e2918 > 0i)))];
let _e2930 = ((_e2912 >> bitcast<u32>((_e2905 & 31u))) | ((_e2923 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2905) & 31u))));
let _e2931 = local.member_1[1u];
let _e2937 = f32(bitcast<i32>(((_e2930 >> bitcast<u32>((_e2931 & 31u))) & 255u)));
let _e2938 = local.member_1[2u];
let _e2945 = local_1[0u];
let _e2948 = (_e2937 + ((f32(bitcast<i32>(((_e2930 >> bitcast<u32>((_e2938 & 31u))) & 255u))) - _e2937) * _e2945));
let _e2950 = local.member[0u];
let _e2951 = ((_e2771 + _e2769) + _e2950);
let _e2953 = (_e2951 >> bitcast<u32>(2i));
let _e2956 = bitcast<u32>(((_e2951 & 3i) * 8i));
let _e2958 = select(_e2794, _e2953, (_e2953 < _e2794));
let _e2963 = global_2.member[bitcast<u32>(select(0i, _e2958, (_e2958 > 0i)))];
let _e2967 = (_e2953 + 1i);
let _e2969 = select(_e2794, _e2967, (_e2967 < _e2794));
let _e2974 = global_2.member[bitcast<u32>(select(0i, _e2969, (_e2969 > 0i)))];
let _e2981 = ((_e2963 >> bitcast<u32>((_e2956 & 31u))) | ((_e2974 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2956) & 31u))));
let _e2982 = local.member_1[1u];
let _e2988 = f32(bitcast<i32>(((_e2981 >> bitcast<u32>((_e2982 & 31u))) & 255u)));
let _e2989 = local.member_1[2u];
let _e2996 = local_1[0u];
let _e3000 = local_1[1u];
let _e3005 = local_1[2u];
let _e3012 = global_1.member.member_6.member_5;
let _e3017 = global_1.member.member_6.member_6;
let _e3018 = (((_e2897 + (((_e2948 + (((_e2988 + ((f32(bitcast<i32>(((_e2981 >> bitcast<u32>((_e2989 & 31u))) & 255u))) - _e2988) * _e2996)) - _e2948) * _e3000)) - _e2897) * _e3005)) * _e3012) + _e3017);
let _e3020 = select(0f, _e3018, (_e3018 > 0f));
let _e3022 = select(1f, _e3020, (_e3020 < 1f));
let _e3025 = global_1.member.member_1;
if ((_e3025 & 16u) == 0u) {
phi_5117_ = type_5(1f, 1f, 1f);
} else {
let _e3031 = global_1.member.member_14.member;
let _e3042 = ((((_e3031.member.member * _e622) + (_e3031.member.member_1 * _e635)) + (_e3031.member.member_2 * _e600)) + _e3031.member_1);
let _e3048 = ((((_e3031.member.member * _e645) + (_e3031.member.member_1 * _e650)) + (_e3031.member.member_2 * _e639)) + _e3031.member_1);
let _e3050 = select(_e3048, _e3042, (_e3042 < _e3048));
let _e3052 = select(_e3048, _e3042, (_e3042 > _e3048));
let _e3054 = (_e3052 - _e3050);
let _e3057 = (-(_e3050) / select(1e-30f, _e3054, (_e3054 > 1e-30f)));
let _e3059 = select(0f, _e3057, (_e3057 > 0f));
let _e3065 = select(select(select(1f, _e3059, (_e3059 < 1f)), 1f, (_e3052 <= 0f)), 0f, (_e3050 > 0f));
let _e3070 = global_1.member.member_14.member_1;
let _e3071 = (_e3070 != 0u);
let _e3081 = global_1.member.member_15.member;
let _e3092 = ((((_e3081.member.member * _e622) + (_e3081.member.member_1 * _e635)) + (_e3081.member.member_2 * _e600)) + _e3081.member_1);
let _e3098 = ((((_e3081.member.member * _e645) + (_e3081.member.member_1 * _e650)) + (_e3081.member.member_2 * _e639)) + _e3081.member_1);
let _e3100 = select(_e3098, _e3092, (_e3092 < _e3098));
let _e3102 = select(_e3098, _e3092, (_e3092 > _e3098));
let _e3104 = (_e3102 - _e3100);
let _e3107 = (-(_e3100) / select(1e-30f, _e3104, (_e3104 > 1e-30f)));
let _e3109 = select(0f, _e3107, (_e3107 > 0f));
let _e3115 = select(select(select(1f, _e3109, (_e3109 < 1f)), 1f, (_e3102 <= 0f)), 0f, (_e3100 > 0f));
let _e3120 = global_1.member.member_15.member_1;
let _e3121 = (_e3120 != 0u);
let _e3131 = global_1.member.member_16.member;
let _e3142 = ((((_e3131.member.member * _e622) + (_e3131.member.member_1 * _e635)) + (_e3131.member.member_2 * _e600)) + _e3131.member_1);
let _e3148 = ((((_e3131.member.member * _e645) + (_e3131.member.member_1 * _e650)) + (_e3131.member.member_2 * _e639)) + _e3131.member_1);
let _e3150 = select(_e3148, _e3142, (_e3142 < _e3148));
let _e3152 = select(_e3148, _e3142, (_e3142 > _e3148));
let _e3154 = (_e3152 - _e3150);
let _e3157 = (-(_e3150) / select(1e-30f, _e3154, (_e3154 > 1e-30f)));
let _e3159 = select(0f, _e3157, (_e3157 > 0f));
let _e3165 = select(select(select(1f, _e3159, (_e3159 < 1f)), 1f, (_e3152 <= 0f)), 0f, (_e3150 > 0f));
let _e3170 = global_1.member.member_16.member_1;
let _e3171 = (_e3170 != 0u);
let _e3181 = global_1.member.member_17.member;
let _e3192 = ((((_e3181.member.member * _e622) + (_e3181.member.member_1 * _e635)) + (_e3181.member.member_2 * _e600)) + _e3181.member_1);
let _e3198 = ((((_e3181.member.member * _e645) + (_e3181.member.member_1 * _e650)) + (_e3181.member.member_2 * _e639)) + _e3181.member_1);
let _e3200 = select(_e3198, _e3192, (_e3192 < _e3198));
let _e3202 = select(_e3198, _e3192, (_e3192 > _e3198));
let _e3204 = (_e3202 - _e3200);
let _e3207 = (-(_e3200) / select(1e-30f, _e3204, (_e3204 > 1e-30f)));
let _e3209 = select(0f, _e3207, (_e3207 > 0f));
let _e3215 = select(select(select(1f, _e3209, (_e3209 < 1f)), 1f, (_e3202 <= 0f)), 0f, (_e3200 > 0f));
let _e3220 = global_1.member.member_17.member_1;
let _e3221 = (_e3220 != 0u);
phi_5117_ = type_5(((((1f * _e3065) * _e3115) * _e3165) * _e3215), ((((1f * select(1f, _e3065, _e3071)) * select(1f, _e3115, _e3121)) * select(1f, _e3165, _e3171)) * select(1f, _e3215, _e3221)), ((((1f * select(1f, 0f, (_e3071 && (_e3048 > 0f)))) * select(1f, 0f, (_e3121 && (_e3098 > 0f)))) * select(1f, 0f, (_e3171 && (_e3148 > 0f)))) * select(1f, 0f, (_e3221 && (_e3198 > 0f)))));
}
let _e3230 = phi_5117_;
let _e3231 = (_e701 - _e665);
let _e3235 = (bitcast<f32>((bitcast<u32>(_e3231) & 2147483647u)) < 1e-12f);
let _e3237 = (1f / select(_e3231, 1f, _e3235));
let _e3239 = ((-0.5f - _e665) * _e3237);
let _e3241 = ((_e2628 - _e665) * _e3237);
let _e3247 = select(_e3241, _e3239, (_e3239 < _e3241));
let _e3249 = select(0f, _e3247, (_e3247 > 0f));
let _e3252 = select(select(1f, _e3249, (_e3249 < 1f)), select(2f, 0f, ((_e665 >= -0.5f) && (_e665 <= _e2628))), _e3235);
let _e3254 = select(_e3241, _e3239, (_e3239 > _e3241));
let _e3256 = select(0f, _e3254, (_e3254 > 0f));
let _e3259 = select(select(1f, _e3256, (_e3256 < 1f)), 1f, _e3235);
let _e3260 = (_e707 - _e680);
let _e3264 = (bitcast<f32>((bitcast<u32>(_e3260) & 2147483647u)) < 1e-12f);
let _e3266 = (1f / select(_e3260, 1f, _e3264));
let _e3268 = ((-0.5f - _e680) * _e3266);
let _e3270 = ((_e2638 - _e680) * _e3266);
let _e3276 = select(_e3270, _e3268, (_e3268 < _e3270));
let _e3278 = select(0f, _e3276, (_e3276 > 0f));
let _e3281 = select(select(1f, _e3278, (_e3278 < 1f)), select(2f, 0f, ((_e680 >= -0.5f) && (_e680 <= _e2638))), _e3264);
let _e3283 = select(_e3270, _e3268, (_e3268 > _e3270));
let _e3285 = select(0f, _e3283, (_e3283 > 0f));
let _e3288 = select(select(1f, _e3285, (_e3285 < 1f)), 1f, _e3264);
let _e3289 = (_e713 - _e695);
let _e3293 = (bitcast<f32>((bitcast<u32>(_e3289) & 2147483647u)) < 1e-12f);
let _e3295 = (1f / select(_e3289, 1f, _e3293));
let _e3297 = ((-0.5f - _e695) * _e3295);
let _e3299 = ((_e2648 - _e695) * _e3295);
let _e3305 = select(_e3299, _e3297, (_e3297 < _e3299));
let _e3307 = select(0f, _e3305, (_e3305 > 0f));
let _e3310 = select(select(1f, _e3307, (_e3307 < 1f)), select(2f, 0f, ((_e695 >= -0.5f) && (_e695 <= _e2648))), _e3293);
let _e3312 = select(_e3299, _e3297, (_e3297 > _e3299));
let _e3314 = select(0f, _e3312, (_e3312 > 0f));
let _e3317 = select(select(1f, _e3314, (_e3314 < 1f)), 1f, _e3293);
let _e3319 = select(_e3288, _e3259, (_e3259 < _e3288));
let _e3323 = select(_e3281, _e3252, (_e3252 > _e3281));
let _e3326 = (select(_e3317, _e3319, (_e3319 < _e3317)) - select(_e3310, _e3323, (_e3323 > _e3310)));
let _e3329 = (_e645 - _e622);
let _e3330 = (_e650 - _e635);
let _e3331 = (_e639 - _e600);
let _e3336 = (((_e3329 * _e3329) + (_e3330 * _e3330)) + (_e3331 * _e3331));
let _e3344 = global_1.member.member_5.member_3;
let _e3345 = ((sqrt(select(0f, _e3336, (_e3336 > 0f))) * select(0f, _e3326, (_e3326 > 0f))) * _e3344);
if (_e102.member_2 >= 3u) {
let _e3348 = (_e3022 * 255f);
let _e3349 = (_e2622.member * 255f);
let _e3350 = (255f - 1f);
let _e3352 = select(0f, _e3348, (_e3348 > 0f));
let _e3354 = select(_e3350, _e3352, (_e3352 < _e3350));
let _e3361 = select(0i, select(select(i32(_e3354), i32(-2147483648), (_e3354 < -2147483600f)), 2147483647i, (_e3354 > 2147483500f)), (_e3354 == _e3354));
let _e3365 = (_e3361 - select(0i, 1i, (_e3354 < f32(_e3361))));
let _e3367 = select(0f, _e3349, (_e3349 > 0f));
let _e3369 = select(_e3350, _e3367, (_e3367 < _e3350));
let _e3376 = select(0i, select(select(i32(_e3369), i32(-2147483648), (_e3369 < -2147483600f)), 2147483647i, (_e3369 > 2147483500f)), (_e3369 == _e3369));
let _e3380 = (_e3376 - select(0i, 1i, (_e3369 < f32(_e3376))));
let _e3383 = (((_e3365 * 256i) + _e3380) * 4i);
let _e3387 = (_e3349 - f32(_e3380));
let _e3389 = (bitcast<i32>(_e92) - 1i);
let _e3391 = select(_e3389, _e3383, (_e3383 < _e3389));
let _e3397 = global_4.member[bitcast<u32>(select(0i, _e3391, (_e3391 > 0i)))];
let _e3398 = (_e3383 + 4i);
let _e3400 = select(_e3389, _e3398, (_e3398 < _e3389));
let _e3406 = global_4.member[bitcast<u32>(select(0i, _e3400, (_e3400 > 0i)))];
let _e3407 = (_e3383 + 1024i);
let _e3409 = select(_e3389, _e3407, (_e3407 < _e3389));
let _e3415 = global_4.member[bitcast<u32>(select(0i, _e3409, (_e3409 > 0i)))];
let _e3416 = (_e3383 + 1028i);
let _e3418 = select(_e3389, _e3416, (_e3416 < _e3389));
let _e3424 = global_4.member[bitcast<u32>(select(0i, _e3418, (_e3418 > 0i)))];
let _e3429 = (bitcast<f32>(((_e3397 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3437 = (_e3429 + (((bitcast<f32>(((_e3406 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3429) * _e3387));
let _e3442 = (bitcast<f32>(((_e3415 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3453 = (_e3437 + (((_e3442 + (((bitcast<f32>(((_e3424 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3442) * _e3387)) - _e3437) * (_e3348 - f32(_e3365))));
let _e3457 = -((_e3453 * (_e3345 * _e3230.member)));
let _e3459 = select(-87f, _e3457, (_e3457 > -87f));
let _e3461 = select(88f, _e3459, (_e3459 < 88f));
let _e3463 = ((_e3461 * 1.442695f) + 0.5f);
let _e3465 = select(-127f, _e3463, (_e3463 > -127f));
let _e3467 = select(128f, _e3465, (_e3465 < 128f));
let _e3474 = select(0i, select(select(i32(_e3467), i32(-2147483648), (_e3467 < -2147483600f)), 2147483647i, (_e3467 > 2147483500f)), (_e3467 == _e3467));
let _e3478 = (_e3474 - select(0i, 1i, (_e3467 < f32(_e3474))));
let _e3479 = f32(_e3478);
let _e3483 = ((_e3461 - (_e3479 * 0.6933594f)) - (_e3479 * -2.1219444e-4f));
let _e3503 = ((1f + (_e3483 * (1f + (_e3483 * (0.5f + (_e3483 * (0.16666667f + (_e3483 * (0.041666668f + (_e3483 * (0.008333334f + (_e3483 * (0.001388889f + (_e3483 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3478 + 127i)) << bitcast<u32>(23i))));
let _e3504 = (1f - _e3503);
phi_6227_ = type_31(_e3503, _e3504, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3504 / select(1e-12f, _e3453, (_e3453 > 1e-12f))))));
} else {
let _e3512 = (_e3022 * 255f);
let _e3513 = (_e2622.member * 255f);
let _e3514 = (255f - 1f);
let _e3516 = select(0f, _e3512, (_e3512 > 0f));
let _e3518 = select(_e3514, _e3516, (_e3516 < _e3514));
let _e3525 = select(0i, select(select(i32(_e3518), i32(-2147483648), (_e3518 < -2147483600f)), 2147483647i, (_e3518 > 2147483500f)), (_e3518 == _e3518));
let _e3529 = (_e3525 - select(0i, 1i, (_e3518 < f32(_e3525))));
let _e3531 = select(0f, _e3513, (_e3513 > 0f));
let _e3533 = select(_e3514, _e3531, (_e3531 < _e3514));
let _e3540 = select(0i, select(select(i32(_e3533), i32(-2147483648), (_e3533 < -2147483600f)), 2147483647i, (_e3533 > 2147483500f)), (_e3533 == _e3533));
let _e3544 = (_e3540 - select(0i, 1i, (_e3533 < f32(_e3540))));
let _e3547 = (((_e3529 * 256i) + _e3544) * 4i);
let _e3549 = (_e3512 - f32(_e3529));
let _e3551 = (_e3513 - f32(_e3544));
let _e3553 = (bitcast<i32>(_e92) - 1i);
let _e3555 = select(_e3553, _e3547, (_e3547 < _e3553));
let _e3561 = global_4.member[bitcast<u32>(select(0i, _e3555, (_e3555 > 0i)))];
let _e3562 = (_e3547 + 4i);
let _e3564 = select(_e3553, _e3562, (_e3562 < _e3553));
let _e3570 = global_4.member[bitcast<u32>(select(0i, _e3564, (_e3564 > 0i)))];
let _e3571 = (_e3547 + 1024i);
let _e3573 = select(_e3553, _e3571, (_e3571 < _e3553));
let _e3579 = global_4.member[bitcast<u32>(select(0i, _e3573, (_e3573 > 0i)))];
let _e3580 = (_e3547 + 1028i);
let _e3582 = select(_e3553, _e3580, (_e3580 < _e3553));
let _e3588 = global_4.member[bitcast<u32>(select(0i, _e3582, (_e3582 > 0i)))];
let _e3593 = (bitcast<f32>(((_e3561 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3601 = (_e3593 + (((bitcast<f32>(((_e3570 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3593) * _e3551));
let _e3606 = (bitcast<f32>(((_e3579 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3617 = (_e3601 + (((_e3606 + (((bitcast<f32>(((_e3588 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3606) * _e3551)) - _e3601) * _e3549));
let _e3630 = (bitcast<f32>((((_e3561 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3638 = (_e3630 + (((bitcast<f32>((((_e3570 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3630) * _e3551));
let _e3643 = (bitcast<f32>((((_e3579 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3655 = (_e3547 + 1i);
let _e3657 = select(_e3553, _e3655, (_e3655 < _e3553));
let _e3663 = global_4.member[bitcast<u32>(select(0i, _e3657, (_e3657 > 0i)))];
let _e3664 = (_e3547 + 5i);
let _e3666 = select(_e3553, _e3664, (_e3664 < _e3553));
let _e3672 = global_4.member[bitcast<u32>(select(0i, _e3666, (_e3666 > 0i)))];
let _e3673 = (_e3547 + 1025i);
let _e3675 = select(_e3553, _e3673, (_e3673 < _e3553));
let _e3681 = global_4.member[bitcast<u32>(select(0i, _e3675, (_e3675 > 0i)))];
let _e3682 = (_e3547 + 1029i);
let _e3684 = select(_e3553, _e3682, (_e3682 < _e3553));
let _e3690 = global_4.member[bitcast<u32>(select(0i, _e3684, (_e3684 > 0i)))];
let _e3695 = (bitcast<f32>(((_e3663 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3703 = (_e3695 + (((bitcast<f32>(((_e3672 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3695) * _e3551));
let _e3708 = (bitcast<f32>(((_e3681 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3732 = (bitcast<f32>((((_e3663 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3740 = (_e3732 + (((bitcast<f32>((((_e3672 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3732) * _e3551));
let _e3745 = (bitcast<f32>((((_e3681 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3760 = (_e3345 * _e3230.member_1);
let _e3762 = -(((_e3638 + (((_e3643 + (((bitcast<f32>((((_e3588 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3643) * _e3551)) - _e3638) * _e3549)) * _e3760));
let _e3764 = select(-87f, _e3762, (_e3762 > -87f));
let _e3766 = select(88f, _e3764, (_e3764 < 88f));
let _e3768 = ((_e3766 * 1.442695f) + 0.5f);
let _e3770 = select(-127f, _e3768, (_e3768 > -127f));
let _e3772 = select(128f, _e3770, (_e3770 < 128f));
let _e3779 = select(0i, select(select(i32(_e3772), i32(-2147483648), (_e3772 < -2147483600f)), 2147483647i, (_e3772 > 2147483500f)), (_e3772 == _e3772));
let _e3783 = (_e3779 - select(0i, 1i, (_e3772 < f32(_e3779))));
let _e3784 = f32(_e3783);
let _e3788 = ((_e3766 - (_e3784 * 0.6933594f)) - (_e3784 * -2.1219444e-4f));
let _e3810 = -(((_e3703 + (((_e3708 + (((bitcast<f32>(((_e3690 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3708) * _e3551)) - _e3703) * _e3549)) * _e3760));
let _e3812 = select(-87f, _e3810, (_e3810 > -87f));
let _e3814 = select(88f, _e3812, (_e3812 < 88f));
let _e3816 = ((_e3814 * 1.442695f) + 0.5f);
let _e3818 = select(-127f, _e3816, (_e3816 > -127f));
let _e3820 = select(128f, _e3818, (_e3818 < 128f));
let _e3827 = select(0i, select(select(i32(_e3820), i32(-2147483648), (_e3820 < -2147483600f)), 2147483647i, (_e3820 > 2147483500f)), (_e3820 == _e3820));
let _e3831 = (_e3827 - select(0i, 1i, (_e3820 < f32(_e3827))));
let _e3832 = f32(_e3831);
let _e3836 = ((_e3814 - (_e3832 * 0.6933594f)) - (_e3832 * -2.1219444e-4f));
let _e3858 = -(((_e3740 + (((_e3745 + (((bitcast<f32>((((_e3690 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3745) * _e3551)) - _e3740) * _e3549)) * _e3760));
let _e3860 = select(-87f, _e3858, (_e3858 > -87f));
let _e3862 = select(88f, _e3860, (_e3860 < 88f));
let _e3864 = ((_e3862 * 1.442695f) + 0.5f);
let _e3866 = select(-127f, _e3864, (_e3864 > -127f));
let _e3868 = select(128f, _e3866, (_e3866 < 128f));
let _e3875 = select(0i, select(select(i32(_e3868), i32(-2147483648), (_e3868 < -2147483600f)), 2147483647i, (_e3868 > 2147483500f)), (_e3868 == _e3868));
let _e3879 = (_e3875 - select(0i, 1i, (_e3868 < f32(_e3875))));
let _e3880 = f32(_e3879);
let _e3884 = ((_e3862 - (_e3880 * 0.6933594f)) - (_e3880 * -2.1219444e-4f));
let _e3907 = -((_e3617 * (_e3345 * _e3230.member)));
let _e3909 = select(-87f, _e3907, (_e3907 > -87f));
let _e3911 = select(88f, _e3909, (_e3909 < 88f));
let _e3913 = ((_e3911 * 1.442695f) + 0.5f);
let _e3915 = select(-127f, _e3913, (_e3913 > -127f));
let _e3917 = select(128f, _e3915, (_e3915 < 128f));
let _e3924 = select(0i, select(select(i32(_e3917), i32(-2147483648), (_e3917 < -2147483600f)), 2147483647i, (_e3917 > 2147483500f)), (_e3917 == _e3917));
let _e3928 = (_e3924 - select(0i, 1i, (_e3917 < f32(_e3924))));
let _e3929 = f32(_e3928);
let _e3933 = ((_e3911 - (_e3929 * 0.6933594f)) - (_e3929 * -2.1219444e-4f));
let _e3953 = ((1f + (_e3933 * (1f + (_e3933 * (0.5f + (_e3933 * (0.16666667f + (_e3933 * (0.041666668f + (_e3933 * (0.008333334f + (_e3933 * (0.001388889f + (_e3933 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3928 + 127i)) << bitcast<u32>(23i))));
let _e3954 = (1f - _e3953);
phi_6227_ = type_31(_e3953, _e3954, vec3<f32>(((1f + (_e3788 * (1f + (_e3788 * (0.5f + (_e3788 * (0.16666667f + (_e3788 * (0.041666668f + (_e3788 * (0.008333334f + (_e3788 * (0.001388889f + (_e3788 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3783 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3836 * (1f + (_e3836 * (0.5f + (_e3836 * (0.16666667f + (_e3836 * (0.041666668f + (_e3836 * (0.008333334f + (_e3836 * (0.001388889f + (_e3836 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3831 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3884 * (1f + (_e3884 * (0.5f + (_e3884 * (0.16666667f + (_e3884 * (0.041666668f + (_e3884 * (0.008333334f + (_e3884 * (0.001388889f + (_e3884 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3879 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3954 / select(1e-12f, _e3617, (_e3617 > 1e-12f))))));
}
let _e3962 = phi_6227_;
if _e718 {
let _e3966 = global_1.member.member_5.member_2;
let _e3974 = global_1.member.member_5.member_4;
let _e3977 = (_e2622.member_3.x * _e3230.member_2);
let _e3979 = (_e2622.member_3.y * _e3230.member_2);
let _e3981 = (_e2622.member_3.z * _e3230.member_2);
let _e3982 = (0.5f * (_e3966 / select(1e-6f, _e182, (_e182 > 1e-6f))));
let _e3986 = (_e160 + (_e3977 * _e3982));
let _e3987 = (_e171 + (_e3979 * _e3982));
let _e3988 = (_e182 + (_e3981 * _e3982));
let _e3990 = (2f * _e3966);
let _e3992 = ((_e3988 * _e3988) + (_e3990 * _e3981));
let _e3996 = (_e3988 + sqrt(select(0f, _e3992, (_e3992 > 0f))));
let _e4000 = (0.5f * (_e3990 / select(1e-6f, _e3996, (_e3996 > 1e-6f))));
let _e4004 = (_e3986 + (_e3977 * _e4000));
let _e4005 = (_e3987 + (_e3979 * _e4000));
let _e4006 = (_e3988 + (_e3981 * _e4000));
let _e4010 = (_e3974 * _e3974);
let _e4012 = (_e4006 * _e4006);
let _e4020 = (((_e3988 <= 0f) || (_e3992 <= 0f)) || ((_e4006 <= 0f) || (_e4012 <= (_e4010 * (((_e4004 * _e4004) + (_e4005 * _e4005)) + _e4012)))));
let _e4034 = (_e160 + ((_e2622.member_4.x * _e3230.member_2) * _e3966));
let _e4035 = (_e171 + ((_e2622.member_4.y * _e3230.member_2) * _e3966));
let _e4036 = (_e182 + ((_e2622.member_4.z * _e3230.member_2) * _e3966));
let _e4038 = (_e4036 * _e4036);
let _e4047 = ((_e3025 & 1u) != 0u);
let _e4051 = select(_e4020, ((_e4036 <= 0f) || (_e4038 <= (_e4010 * (((_e4034 * _e4034) + (_e4035 * _e4035)) + _e4038)))), _e4047);
phi_6378_ = select(select(select(_e4006, _e3988, _e4020), _e4036, _e4047), _e182, _e4051);
phi_6379_ = select(select(select(_e4005, _e3987, _e4020), _e4035, _e4047), _e171, _e4051);
phi_6380_ = select(select(select(_e4004, _e3986, _e4020), _e4034, _e4047), _e160, _e4051);
phi_6381_ = select(1f, 0f, _e4051);
} else {
phi_6378_ = _e182;
phi_6379_ = _e171;
phi_6380_ = _e160;
phi_6381_ = 1f;
}
let _e4057 = phi_6378_;
let _e4059 = phi_6379_;
let _e4061 = phi_6380_;
let _e4063 = phi_6381_;
let _e4066 = (_e3962.member * _e4063);
global_5.member[_e117] = (_e128 * (_e3962.member_2.x * _e4066));
global_5.member[_e129] = (_e138 * (_e3962.member_2.y * _e4066));
global_5.member[_e140] = (_e149 * (_e3962.member_2.z * _e4066));
global_5.member[_e151] = _e4061;
global_5.member[_e162] = _e4059;
global_5.member[_e173] = _e4057;
global_5.member[_e184] = _e193;
global_5.member[_e195] = _e204;
global_5.member[_e206] = _e215;
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
