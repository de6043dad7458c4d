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
var phi_942_: u32;
var phi_3409_: type_29;
var phi_4171_: type_30;
var phi_5120_: type_5;
var phi_6230_: type_31;
var phi_6382_: vec3<f32>;
var phi_6383_: f32;
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
phi_942_ = select(select(7u, 3u, (((((((_e315 >= 0f) && (_e315 <= _e370)) && (_e330 >= 0f)) && (_e330 <= _e380)) && (_e345 >= 0f)) && (_e345 <= _e390)) && ((((((_e351 >= 0f) && (_e351 <= _e370)) && (_e357 >= 0f)) && (_e357 <= _e380)) && (_e363 >= 0f)) && (_e363 <= _e390)))), 1u, (((_e555 & 64u) != 0u) || ((((select(_e438, _e435, (_e435 > _e438)) <= _e409) && ((select(_e455, _e452, (_e452 > _e455)) > _e409) || (_e549 != 0u))) && true) && ((_e555 & 32u) != 0u))));
} else {
phi_942_ = 7u;
}
let _e565 = phi_942_;
if (_e565 > 1u) {
let _e571 = bitcast<i32>(((_e112 * _e219) + _e110));
let _e574 = (bitcast<i32>(_e94) - 1i);
let _e576 = select(_e574, _e571, (_e571 < _e574));
let _e582 = global_6.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e583 = (bitcast<i32>(_e224) + _e571);
let _e585 = select(_e574, _e583, (_e583 < _e574));
let _e591 = global_6.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e593 = f32(bitcast<i32>(_e110));
let _e595 = f32(bitcast<i32>(_e112));
let _e601 = global_1.member.member_5.member;
let _e605 = global_1.member.member_8.member_8;
let _e606 = (_e601 - _e605);
let _e610 = global_1.member.member_8.member_2;
let _e614 = global_1.member.member_8.member_6;
let _e621 = global_1.member.member_8.member_4;
let _e623 = ((_e610 + (_e614 * _e606)) + (((_e593 - _e582) + 0.5f) * _e621));
let _e627 = global_1.member.member_8.member_3;
let _e631 = global_1.member.member_8.member_7;
let _e636 = ((_e627 + (_e631 * _e606)) + (((_e595 - _e591) + 0.5f) * _e621));
let _e640 = global_1.member.member_5.member_1;
let _e641 = (_e640 - _e605);
let _e646 = ((_e610 + (_e614 * _e641)) + ((_e593 + 0.5f) * _e621));
let _e651 = ((_e627 + (_e631 * _e641)) + ((_e595 + 0.5f) * _e621));
let _e655 = global_1.member.member_6.member;
let _e666 = ((((_e655.member.member * _e623) + (_e655.member.member_1 * _e636)) + (_e655.member.member_2 * _e601)) + _e655.member_1);
let _e670 = global_1.member.member_6.member_1;
let _e681 = ((((_e670.member.member * _e623) + (_e670.member.member_1 * _e636)) + (_e670.member.member_2 * _e601)) + _e670.member_1);
let _e685 = global_1.member.member_6.member_2;
let _e696 = ((((_e685.member.member * _e623) + (_e685.member.member_1 * _e636)) + (_e685.member.member_2 * _e601)) + _e685.member_1);
let _e702 = ((((_e655.member.member * _e646) + (_e655.member.member_1 * _e651)) + (_e655.member.member_2 * _e640)) + _e655.member_1);
let _e708 = ((((_e670.member.member * _e646) + (_e670.member.member_1 * _e651)) + (_e670.member.member_2 * _e640)) + _e670.member_1);
let _e714 = ((((_e685.member.member * _e646) + (_e685.member.member_1 * _e651)) + (_e685.member.member_2 * _e640)) + _e685.member_1);
let _e716 = (_e102.member_2 == 2u);
let _e719 = (((_e102.member_2 == 1u) || _e716) || (_e102.member_2 == 5u));
if _e719 {
let _e724 = global_1.member.member_6.member_3.member;
let _e725 = (_e724 - 0.5f);
let _e727 = select(-0.5f, _e702, (_e702 > -0.5f));
let _e729 = select(_e725, _e727, (_e727 < _e725));
let _e734 = global_1.member.member_6.member_3.member_1;
let _e735 = (_e734 - 0.5f);
let _e737 = select(-0.5f, _e708, (_e708 > -0.5f));
let _e739 = select(_e735, _e737, (_e737 < _e735));
let _e744 = global_1.member.member_6.member_3.member_2;
let _e745 = (_e744 - 0.5f);
let _e747 = select(-0.5f, _e714, (_e714 > -0.5f));
let _e749 = select(_e745, _e747, (_e747 < _e745));
let _e751 = select(-1f, _e729, (_e729 > -1f));
let _e753 = select(_e724, _e751, (_e751 < _e724));
let _e760 = select(0i, select(select(i32(_e753), i32(-2147483648), (_e753 < -2147483600f)), 2147483647i, (_e753 > 2147483500f)), (_e753 == _e753));
let _e764 = (_e760 - select(0i, 1i, (_e753 < f32(_e760))));
let _e766 = select(-1f, _e739, (_e739 > -1f));
let _e768 = select(_e734, _e766, (_e766 < _e734));
let _e775 = select(0i, select(select(i32(_e768), i32(-2147483648), (_e768 < -2147483600f)), 2147483647i, (_e768 > 2147483500f)), (_e768 == _e768));
let _e779 = (_e775 - select(0i, 1i, (_e768 < f32(_e775))));
let _e781 = select(-1f, _e749, (_e749 > -1f));
let _e783 = select(_e744, _e781, (_e781 < _e744));
let _e790 = select(0i, select(select(i32(_e783), i32(-2147483648), (_e783 < -2147483600f)), 2147483647i, (_e783 > 2147483500f)), (_e783 == _e783));
let _e794 = (_e790 - select(0i, 1i, (_e783 < f32(_e790))));
let _e798 = global_1.member.member_6.member_7;
let _e802 = global_1.member.member_6.member_8;
let _e810 = (select(0i, select(select(i32(_e734), i32(-2147483648), (_e734 < -2147483600f)), 2147483647i, (_e734 > 2147483500f)), (_e734 == _e734)) - 1i);
let _e811 = (_e779 - 1i);
let _e816 = (_e779 + 1i);
let _e819 = (_e779 + 2i);
let _e829 = (select(0i, select(select(i32(_e744), i32(-2147483648), (_e744 < -2147483600f)), 2147483647i, (_e744 > 2147483500f)), (_e744 == _e744)) - 1i);
let _e830 = (_e794 - 1i);
let _e835 = (_e794 + 1i);
let _e838 = (_e794 + 2i);
let _e847 = select(0i, select(select(i32(_e724), i32(-2147483648), (_e724 < -2147483600f)), 2147483647i, (_e724 > 2147483500f)), (_e724 == _e724));
let _e848 = (_e847 - 1i);
let _e849 = (_e764 - 1i);
let _e851 = select(0i, _e849, (_e849 > 0i));
let _e854 = (_e764 + 1i);
let _e857 = (_e764 + 2i);
let _e860 = (_e847 - 4i);
let _e862 = select(0i, _e860, (_e860 > 0i));
let _e864 = select(_e862, _e851, (_e851 < _e862));
let _e877 = (select(0i, _e811, (_e811 > 0i)) * _e798);
let _e878 = (select(0i, _e779, (_e779 > 0i)) * _e798);
let _e879 = (select(_e810, _e816, (_e816 < _e810)) * _e798);
let _e880 = (select(_e810, _e819, (_e819 < _e810)) * _e798);
let _e881 = (select(0i, _e830, (_e830 > 0i)) * _e802);
let _e882 = (select(0i, _e794, (_e794 > 0i)) * _e802);
let _e883 = (select(_e829, _e835, (_e835 < _e829)) * _e802);
let _e884 = (select(_e829, _e838, (_e838 < _e829)) * _e802);
local_4 = type_28(array<i32, 4>(_e864, _e864, _e864, _e864), array<u32, 6>(bitcast<u32>(((_e851 - _e864) * 8i)), bitcast<u32>(((select(0i, _e764, (_e764 > 0i)) - _e864) * 8i)), bitcast<u32>(((select(_e848, _e854, (_e854 < _e848)) - _e864) * 8i)), bitcast<u32>(((select(_e848, _e857, (_e857 < _e848)) - _e864) * 8i)), 0u, 0u));
local_5 = vec3<f32>((_e729 - f32(_e764)), (_e739 - f32(_e779)), (_e749 - f32(_e794)));
let _e899 = local_4.member[0u];
let _e900 = ((_e882 + _e878) + _e899);
let _e902 = (_e900 >> bitcast<u32>(2i));
let _e905 = bitcast<u32>(((_e900 & 3i) * 8i));
let _e907 = (bitcast<i32>(_e88) - 1i);
let _e909 = select(_e907, _e902, (_e902 < _e907));
let _e914 = global_2.member[bitcast<u32>(select(0i, _e909, (_e909 > 0i)))];
let _e918 = (_e902 + 1i);
let _e920 = select(_e907, _e918, (_e918 < _e907));
let _e925 = global_2.member[bitcast<u32>(select(0i, _e920, (_e920 > 0i)))];
let _e932 = ((_e914 >> bitcast<u32>((_e905 & 31u))) | ((_e925 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e905) & 31u))));
let _e935 = local_4.member_1[0u];
let _e941 = f32(bitcast<i32>(((_e932 >> bitcast<u32>((_e935 & 31u))) & 255u)));
let _e944 = local_4.member_1[1u];
let _e950 = f32(bitcast<i32>(((_e932 >> bitcast<u32>((_e944 & 31u))) & 255u)));
let _e953 = local_4.member_1[2u];
let _e959 = f32(bitcast<i32>(((_e932 >> bitcast<u32>((_e953 & 31u))) & 255u)));
let _e962 = local_4.member_1[3u];
let _e969 = local_5[0u];
let _e972 = (_e941 + ((_e950 - _e941) * _e969));
let _e973 = local_5[0u];
let _e976 = (_e950 + ((_e959 - _e950) * _e973));
let _e977 = local_5[0u];
let _e980 = (_e959 + ((f32(bitcast<i32>(((_e932 >> bitcast<u32>((_e962 & 31u))) & 255u))) - _e959) * _e977));
let _e982 = local_4.member[0u];
let _e983 = ((_e882 + _e879) + _e982);
let _e985 = (_e983 >> bitcast<u32>(2i));
let _e988 = bitcast<u32>(((_e983 & 3i) * 8i));
let _e990 = select(_e907, _e985, (_e985 < _e907));
let _e995 = global_2.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e999 = (_e985 + 1i);
let _e1001 = select(_e907, _e999, (_e999 < _e907));
let _e1006 = global_2.member[bitcast<u32>(select(0i, _e1001, (_e1001 > 0i)))];
let _e1013 = ((_e995 >> bitcast<u32>((_e988 & 31u))) | ((_e1006 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e988) & 31u))));
let _e1014 = local_4.member_1[0u];
let _e1020 = f32(bitcast<i32>(((_e1013 >> bitcast<u32>((_e1014 & 31u))) & 255u)));
let _e1021 = local_4.member_1[1u];
let _e1027 = f32(bitcast<i32>(((_e1013 >> bitcast<u32>((_e1021 & 31u))) & 255u)));
let _e1028 = local_4.member_1[2u];
let _e1034 = f32(bitcast<i32>(((_e1013 >> bitcast<u32>((_e1028 & 31u))) & 255u)));
let _e1035 = local_4.member_1[3u];
let _e1042 = local_5[0u];
let _e1046 = local_5[0u];
let _e1049 = (_e1027 + ((_e1034 - _e1027) * _e1046));
let _e1050 = local_5[0u];
let _e1055 = local_4.member[0u];
let _e1056 = ((_e883 + _e878) + _e1055);
let _e1058 = (_e1056 >> bitcast<u32>(2i));
let _e1061 = bitcast<u32>(((_e1056 & 3i) * 8i));
let _e1063 = select(_e907, _e1058, (_e1058 < _e907));
let _e1068 = global_2.member[bitcast<u32>(select(0i, _e1063, (_e1063 > 0i)))];
let _e1072 = (_e1058 + 1i);
let _e1074 = select(_e907, _e1072, (_e1072 < _e907));
let _e1079 = global_2.member[bitcast<u32>(select(0i, _e1074, (_e1074 > 0i)))];
let _e1086 = ((_e1068 >> bitcast<u32>((_e1061 & 31u))) | ((_e1079 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1061) & 31u))));
let _e1087 = local_4.member_1[0u];
let _e1093 = f32(bitcast<i32>(((_e1086 >> bitcast<u32>((_e1087 & 31u))) & 255u)));
let _e1094 = local_4.member_1[1u];
let _e1100 = f32(bitcast<i32>(((_e1086 >> bitcast<u32>((_e1094 & 31u))) & 255u)));
let _e1101 = local_4.member_1[2u];
let _e1107 = f32(bitcast<i32>(((_e1086 >> bitcast<u32>((_e1101 & 31u))) & 255u)));
let _e1108 = local_4.member_1[3u];
let _e1115 = local_5[0u];
let _e1118 = (_e1093 + ((_e1100 - _e1093) * _e1115));
let _e1119 = local_5[0u];
let _e1122 = (_e1100 + ((_e1107 - _e1100) * _e1119));
let _e1123 = local_5[0u];
let _e1126 = (_e1107 + ((f32(bitcast<i32>(((_e1086 >> bitcast<u32>((_e1108 & 31u))) & 255u))) - _e1107) * _e1123));
let _e1128 = local_4.member[0u];
let _e1129 = ((_e883 + _e879) + _e1128);
let _e1131 = (_e1129 >> bitcast<u32>(2i));
let _e1134 = bitcast<u32>(((_e1129 & 3i) * 8i));
let _e1136 = select(_e907, _e1131, (_e1131 < _e907));
let _e1141 = global_2.member[bitcast<u32>(select(0i, _e1136, (_e1136 > 0i)))];
let _e1145 = (_e1131 + 1i);
let _e1147 = select(_e907, _e1145, (_e1145 < _e907));
let _e1152 = global_2.member[bitcast<u32>(select(0i, _e1147, (_e1147 > 0i)))];
let _e1159 = ((_e1141 >> bitcast<u32>((_e1134 & 31u))) | ((_e1152 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1134) & 31u))));
let _e1160 = local_4.member_1[0u];
let _e1166 = f32(bitcast<i32>(((_e1159 >> bitcast<u32>((_e1160 & 31u))) & 255u)));
let _e1167 = local_4.member_1[1u];
let _e1173 = f32(bitcast<i32>(((_e1159 >> bitcast<u32>((_e1167 & 31u))) & 255u)));
let _e1174 = local_4.member_1[2u];
let _e1180 = f32(bitcast<i32>(((_e1159 >> bitcast<u32>((_e1174 & 31u))) & 255u)));
let _e1181 = local_4.member_1[3u];
let _e1188 = local_5[0u];
let _e1192 = local_5[0u];
let _e1195 = (_e1173 + ((_e1180 - _e1173) * _e1192));
let _e1196 = local_5[0u];
let _e1201 = local_4.member[0u];
let _e1202 = ((_e882 + _e877) + _e1201);
let _e1204 = (_e1202 >> bitcast<u32>(2i));
let _e1207 = bitcast<u32>(((_e1202 & 3i) * 8i));
let _e1209 = select(_e907, _e1204, (_e1204 < _e907));
let _e1214 = global_2.member[bitcast<u32>(select(0i, _e1209, (_e1209 > 0i)))];
let _e1218 = (_e1204 + 1i);
let _e1220 = select(_e907, _e1218, (_e1218 < _e907));
let _e1225 = global_2.member[bitcast<u32>(select(0i, _e1220, (_e1220 > 0i)))];
let _e1232 = ((_e1214 >> bitcast<u32>((_e1207 & 31u))) | ((_e1225 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1207) & 31u))));
let _e1233 = local_4.member_1[1u];
let _e1239 = f32(bitcast<i32>(((_e1232 >> bitcast<u32>((_e1233 & 31u))) & 255u)));
let _e1240 = local_4.member_1[2u];
let _e1247 = local_5[0u];
let _e1250 = (_e1239 + ((f32(bitcast<i32>(((_e1232 >> bitcast<u32>((_e1240 & 31u))) & 255u))) - _e1239) * _e1247));
let _e1252 = local_4.member[0u];
let _e1253 = ((_e882 + _e880) + _e1252);
let _e1255 = (_e1253 >> bitcast<u32>(2i));
let _e1258 = bitcast<u32>(((_e1253 & 3i) * 8i));
let _e1260 = select(_e907, _e1255, (_e1255 < _e907));
let _e1265 = global_2.member[bitcast<u32>(select(0i, _e1260, (_e1260 > 0i)))];
let _e1269 = (_e1255 + 1i);
let _e1271 = select(_e907, _e1269, (_e1269 < _e907));
let _e1276 = global_2.member[bitcast<u32>(select(0i, _e1271, (_e1271 > 0i)))];
let _e1283 = ((_e1265 >> bitcast<u32>((_e1258 & 31u))) | ((_e1276 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1258) & 31u))));
let _e1284 = local_4.member_1[1u];
let _e1290 = f32(bitcast<i32>(((_e1283 >> bitcast<u32>((_e1284 & 31u))) & 255u)));
let _e1291 = local_4.member_1[2u];
let _e1298 = local_5[0u];
let _e1303 = local_4.member[0u];
let _e1304 = ((_e883 + _e877) + _e1303);
let _e1306 = (_e1304 >> bitcast<u32>(2i));
let _e1309 = bitcast<u32>(((_e1304 & 3i) * 8i));
let _e1311 = select(_e907, _e1306, (_e1306 < _e907));
let _e1316 = global_2.member[bitcast<u32>(select(0i, _e1311, (_e1311 > 0i)))];
let _e1320 = (_e1306 + 1i);
let _e1322 = select(_e907, _e1320, (_e1320 < _e907));
let _e1327 = global_2.member[bitcast<u32>(select(0i, _e1322, (_e1322 > 0i)))];
let _e1334 = ((_e1316 >> bitcast<u32>((_e1309 & 31u))) | ((_e1327 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1309) & 31u))));
let _e1335 = local_4.member_1[1u];
let _e1341 = f32(bitcast<i32>(((_e1334 >> bitcast<u32>((_e1335 & 31u))) & 255u)));
let _e1342 = local_4.member_1[2u];
let _e1349 = local_5[0u];
let _e1352 = (_e1341 + ((f32(bitcast<i32>(((_e1334 >> bitcast<u32>((_e1342 & 31u))) & 255u))) - _e1341) * _e1349));
let _e1354 = local_4.member[0u];
let _e1355 = ((_e883 + _e880) + _e1354);
let _e1357 = (_e1355 >> bitcast<u32>(2i));
let _e1360 = bitcast<u32>(((_e1355 & 3i) * 8i));
let _e1362 = select(_e907, _e1357, (_e1357 < _e907));
let _e1367 = global_2.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1371 = (_e1357 + 1i);
let _e1373 = select(_e907, _e1371, (_e1371 < _e907));
let _e1378 = global_2.member[bitcast<u32>(select(0i, _e1373, (_e1373 > 0i)))];
let _e1385 = ((_e1367 >> bitcast<u32>((_e1360 & 31u))) | ((_e1378 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1360) & 31u))));
let _e1386 = local_4.member_1[1u];
let _e1392 = f32(bitcast<i32>(((_e1385 >> bitcast<u32>((_e1386 & 31u))) & 255u)));
let _e1393 = local_4.member_1[2u];
let _e1400 = local_5[0u];
let _e1405 = local_4.member[0u];
let _e1406 = ((_e881 + _e878) + _e1405);
let _e1408 = (_e1406 >> bitcast<u32>(2i));
let _e1411 = bitcast<u32>(((_e1406 & 3i) * 8i));
let _e1413 = select(_e907, _e1408, (_e1408 < _e907));
let _e1418 = global_2.member[bitcast<u32>(select(0i, _e1413, (_e1413 > 0i)))];
let _e1422 = (_e1408 + 1i);
let _e1424 = select(_e907, _e1422, (_e1422 < _e907));
let _e1429 = global_2.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1436 = ((_e1418 >> bitcast<u32>((_e1411 & 31u))) | ((_e1429 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1411) & 31u))));
let _e1437 = local_4.member_1[1u];
let _e1443 = f32(bitcast<i32>(((_e1436 >> bitcast<u32>((_e1437 & 31u))) & 255u)));
let _e1444 = local_4.member_1[2u];
let _e1451 = local_5[0u];
let _e1454 = (_e1443 + ((f32(bitcast<i32>(((_e1436 >> bitcast<u32>((_e1444 & 31u))) & 255u))) - _e1443) * _e1451));
let _e1456 = local_4.member[0u];
let _e1457 = ((_e884 + _e878) + _e1456);
let _e1459 = (_e1457 >> bitcast<u32>(2i));
let _e1462 = bitcast<u32>(((_e1457 & 3i) * 8i));
let _e1464 = select(_e907, _e1459, (_e1459 < _e907));
let _e1469 = global_2.member[bitcast<u32>(select(0i, _e1464, (_e1464 > 0i)))];
let _e1473 = (_e1459 + 1i);
let _e1475 = select(_e907, _e1473, (_e1473 < _e907));
let _e1480 = global_2.member[bitcast<u32>(select(0i, _e1475, (_e1475 > 0i)))];
let _e1487 = ((_e1469 >> bitcast<u32>((_e1462 & 31u))) | ((_e1480 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1462) & 31u))));
let _e1488 = local_4.member_1[1u];
let _e1494 = f32(bitcast<i32>(((_e1487 >> bitcast<u32>((_e1488 & 31u))) & 255u)));
let _e1495 = local_4.member_1[2u];
let _e1502 = local_5[0u];
let _e1505 = (_e1494 + ((f32(bitcast<i32>(((_e1487 >> bitcast<u32>((_e1495 & 31u))) & 255u))) - _e1494) * _e1502));
let _e1507 = local_4.member[0u];
let _e1508 = ((_e881 + _e879) + _e1507);
let _e1510 = (_e1508 >> bitcast<u32>(2i));
let _e1513 = bitcast<u32>(((_e1508 & 3i) * 8i));
let _e1515 = select(_e907, _e1510, (_e1510 < _e907));
let _e1520 = global_2.member[bitcast<u32>(select(0i, _e1515, (_e1515 > 0i)))];
let _e1524 = (_e1510 + 1i);
let _e1526 = select(_e907, _e1524, (_e1524 < _e907));
let _e1531 = global_2.member[bitcast<u32>(select(0i, _e1526, (_e1526 > 0i)))];
let _e1538 = ((_e1520 >> bitcast<u32>((_e1513 & 31u))) | ((_e1531 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1513) & 31u))));
let _e1539 = local_4.member_1[1u];
let _e1545 = f32(bitcast<i32>(((_e1538 >> bitcast<u32>((_e1539 & 31u))) & 255u)));
let _e1546 = local_4.member_1[2u];
let _e1553 = local_5[0u];
let _e1558 = local_4.member[0u];
let _e1559 = ((_e884 + _e879) + _e1558);
let _e1561 = (_e1559 >> bitcast<u32>(2i));
let _e1564 = bitcast<u32>(((_e1559 & 3i) * 8i));
let _e1566 = select(_e907, _e1561, (_e1561 < _e907));
let _e1571 = global_2.member[bitcast<u32>(select(0i, _e1566, (_e1566 > 0i)))];
let _e1575 = (_e1561 + 1i);
let _e1577 = select(_e907, _e1575, (_e1575 < _e907));
let _e1582 = global_2.member[bitcast<u32>(select(0i, _e1577, (_e1577 > 0i)))];
let _e1589 = ((_e1571 >> bitcast<u32>((_e1564 & 31u))) | ((_e1582 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1564) & 31u))));
let _e1590 = local_4.member_1[1u];
let _e1596 = f32(bitcast<i32>(((_e1589 >> bitcast<u32>((_e1590 & 31u))) & 255u)));
let _e1597 = local_4.member_1[2u];
let _e1604 = local_5[0u];
let _e1609 = local_5[1u];
let _e1612 = (_e976 + ((_e1049 - _e976) * _e1609));
let _e1613 = local_5[1u];
let _e1616 = (_e1122 + ((_e1195 - _e1122) * _e1613));
let _e1617 = local_5[1u];
let _e1620 = (_e972 + (((_e1020 + ((_e1027 - _e1020) * _e1042)) - _e972) * _e1617));
let _e1621 = local_5[1u];
let _e1626 = local_5[2u];
let _e1630 = local_5[1u];
let _e1633 = (_e980 + (((_e1034 + ((f32(bitcast<i32>(((_e1013 >> bitcast<u32>((_e1035 & 31u))) & 255u))) - _e1034) * _e1050)) - _e980) * _e1630));
let _e1634 = local_5[1u];
let _e1638 = local_5[2u];
let _e1642 = local_5[1u];
let _e1645 = (_e1250 + ((_e976 - _e1250) * _e1642));
let _e1646 = local_5[1u];
let _e1650 = local_5[2u];
let _e1654 = local_5[1u];
let _e1657 = (_e1049 + (((_e1290 + ((f32(bitcast<i32>(((_e1283 >> bitcast<u32>((_e1291 & 31u))) & 255u))) - _e1290) * _e1298)) - _e1049) * _e1654));
let _e1658 = local_5[1u];
let _e1662 = local_5[2u];
let _e1666 = local_5[1u];
let _e1669 = (_e1454 + (((_e1545 + ((f32(bitcast<i32>(((_e1538 >> bitcast<u32>((_e1546 & 31u))) & 255u))) - _e1545) * _e1553)) - _e1454) * _e1666));
let _e1670 = local_5[2u];
let _e1674 = local_5[1u];
let _e1678 = local_5[2u];
let _e1682 = local_5[2u];
let _e1689 = global_1.member.member_6.member_5;
let _e1694 = global_1.member.member_6.member_6;
let _e1695 = (((_e1612 + ((_e1616 - _e1612) * _e1682)) * _e1689) + _e1694);
let _e1697 = select(0f, _e1695, (_e1695 > 0f));
let _e1699 = select(1f, _e1697, (_e1697 < 1f));
let _e1701 = (((_e1620 + (((_e1118 + (((_e1166 + ((_e1173 - _e1166) * _e1188)) - _e1118) * _e1621)) - _e1620) * _e1626)) * _e1689) + _e1694);
let _e1703 = select(0f, _e1701, (_e1701 > 0f));
let _e1705 = select(1f, _e1703, (_e1703 < 1f));
let _e1707 = (((_e1633 + (((_e1126 + (((_e1180 + ((f32(bitcast<i32>(((_e1159 >> bitcast<u32>((_e1181 & 31u))) & 255u))) - _e1180) * _e1196)) - _e1126) * _e1634)) - _e1633) * _e1638)) * _e1689) + _e1694);
let _e1709 = select(0f, _e1707, (_e1707 > 0f));
let _e1711 = select(1f, _e1709, (_e1709 < 1f));
let _e1713 = (((_e1645 + (((_e1352 + ((_e1122 - _e1352) * _e1646)) - _e1645) * _e1650)) * _e1689) + _e1694);
let _e1715 = select(0f, _e1713, (_e1713 > 0f));
let _e1717 = select(1f, _e1715, (_e1715 < 1f));
let _e1719 = (((_e1657 + (((_e1195 + (((_e1392 + ((f32(bitcast<i32>(((_e1385 >> bitcast<u32>((_e1393 & 31u))) & 255u))) - _e1392) * _e1400)) - _e1195) * _e1658)) - _e1657) * _e1662)) * _e1689) + _e1694);
let _e1721 = select(0f, _e1719, (_e1719 > 0f));
let _e1723 = select(1f, _e1721, (_e1721 < 1f));
let _e1725 = (((_e1669 + ((_e1612 - _e1669) * _e1670)) * _e1689) + _e1694);
let _e1727 = select(0f, _e1725, (_e1725 > 0f));
let _e1729 = select(1f, _e1727, (_e1727 < 1f));
let _e1731 = (((_e1616 + (((_e1505 + (((_e1596 + ((f32(bitcast<i32>(((_e1589 >> bitcast<u32>((_e1597 & 31u))) & 255u))) - _e1596) * _e1604)) - _e1505) * _e1674)) - _e1616) * _e1678)) * _e1689) + _e1694);
let _e1733 = select(0f, _e1731, (_e1731 > 0f));
let _e1735 = select(1f, _e1733, (_e1733 < 1f));
let _e1736 = (_e1699 * 1024f);
let _e1737 = (1024f - 1f);
let _e1739 = select(0f, _e1736, (_e1736 > 0f));
let _e1741 = select(_e1737, _e1739, (_e1739 < _e1737));
let _e1748 = select(0i, select(select(i32(_e1741), i32(-2147483648), (_e1741 < -2147483600f)), 2147483647i, (_e1741 > 2147483500f)), (_e1741 == _e1741));
let _e1752 = (_e1748 - select(0i, 1i, (_e1741 < f32(_e1748))));
let _e1753 = (262147i + _e1752);
let _e1755 = (bitcast<i32>(_e92) - 1i);
let _e1757 = select(_e1755, _e1753, (_e1753 < _e1755));
let _e1763 = global_4.member[bitcast<u32>(select(0i, _e1757, (_e1757 > 0i)))];
let _e1773 = select(_e1755, 262146i, (262146i < _e1755));
let _e1779 = global_4.member[bitcast<u32>(select(0i, _e1773, (_e1773 > 0i)))];
let _e1780 = bitcast<f32>(_e1779);
let _e1781 = (f32((bitcast<i32>((_e1763 & 4095u)) - 2048i)) * _e1780);
let _e1783 = select(_e1755, 262144i, (262144i < _e1755));
let _e1789 = global_4.member[bitcast<u32>(select(0i, _e1783, (_e1783 > 0i)))];
let _e1790 = bitcast<f32>(_e1789);
let _e1792 = select(_e1755, 262145i, (262145i < _e1755));
let _e1798 = global_4.member[bitcast<u32>(select(0i, _e1792, (_e1792 > 0i)))];
let _e1799 = bitcast<f32>(_e1798);
let _e1805 = ((_e1790 + (f32(bitcast<i32>((_e1763 >> bitcast<u32>(12u)))) * _e1799)) + (_e1781 * (_e1736 - f32(_e1752))));
let _e1806 = (_e1781 * 1024f);
if _e716 {
let _e1813 = ((0.5f * (_e1711 - _e1705)) * _e1806);
let _e1814 = ((0.5f * (_e1723 - _e1717)) * _e1806);
let _e1815 = ((0.5f * (_e1735 - _e1729)) * _e1806);
phi_3409_ = type_29(_e1805, vec3<f32>(_e1813, _e1814, _e1815), vec3<f32>((_e1813 * _e1805), (_e1814 * _e1805), (_e1815 * _e1805)));
} else {
let _e1822 = (_e1705 * 1024f);
let _e1824 = select(0f, _e1822, (_e1822 > 0f));
let _e1826 = select(_e1737, _e1824, (_e1824 < _e1737));
let _e1833 = select(0i, select(select(i32(_e1826), i32(-2147483648), (_e1826 < -2147483600f)), 2147483647i, (_e1826 > 2147483500f)), (_e1826 == _e1826));
let _e1837 = (_e1833 - select(0i, 1i, (_e1826 < f32(_e1833))));
let _e1838 = (262147i + _e1837);
let _e1840 = select(_e1755, _e1838, (_e1838 < _e1755));
let _e1846 = global_4.member[bitcast<u32>(select(0i, _e1840, (_e1840 > 0i)))];
let _e1861 = ((_e1790 + (f32(bitcast<i32>((_e1846 >> bitcast<u32>(12u)))) * _e1799)) + ((f32((bitcast<i32>((_e1846 & 4095u)) - 2048i)) * _e1780) * (_e1822 - f32(_e1837))));
let _e1862 = (_e1711 * 1024f);
let _e1864 = select(0f, _e1862, (_e1862 > 0f));
let _e1866 = select(_e1737, _e1864, (_e1864 < _e1737));
let _e1873 = select(0i, select(select(i32(_e1866), i32(-2147483648), (_e1866 < -2147483600f)), 2147483647i, (_e1866 > 2147483500f)), (_e1866 == _e1866));
let _e1877 = (_e1873 - select(0i, 1i, (_e1866 < f32(_e1873))));
let _e1878 = (262147i + _e1877);
let _e1880 = select(_e1755, _e1878, (_e1878 < _e1755));
let _e1886 = global_4.member[bitcast<u32>(select(0i, _e1880, (_e1880 > 0i)))];
let _e1901 = ((_e1790 + (f32(bitcast<i32>((_e1886 >> bitcast<u32>(12u)))) * _e1799)) + ((f32((bitcast<i32>((_e1886 & 4095u)) - 2048i)) * _e1780) * (_e1862 - f32(_e1877))));
let _e1902 = (_e1717 * 1024f);
let _e1904 = select(0f, _e1902, (_e1902 > 0f));
let _e1906 = select(_e1737, _e1904, (_e1904 < _e1737));
let _e1913 = select(0i, select(select(i32(_e1906), i32(-2147483648), (_e1906 < -2147483600f)), 2147483647i, (_e1906 > 2147483500f)), (_e1906 == _e1906));
let _e1917 = (_e1913 - select(0i, 1i, (_e1906 < f32(_e1913))));
let _e1918 = (262147i + _e1917);
let _e1920 = select(_e1755, _e1918, (_e1918 < _e1755));
let _e1926 = global_4.member[bitcast<u32>(select(0i, _e1920, (_e1920 > 0i)))];
let _e1941 = ((_e1790 + (f32(bitcast<i32>((_e1926 >> bitcast<u32>(12u)))) * _e1799)) + ((f32((bitcast<i32>((_e1926 & 4095u)) - 2048i)) * _e1780) * (_e1902 - f32(_e1917))));
let _e1942 = (_e1723 * 1024f);
let _e1944 = select(0f, _e1942, (_e1942 > 0f));
let _e1946 = select(_e1737, _e1944, (_e1944 < _e1737));
let _e1953 = select(0i, select(select(i32(_e1946), i32(-2147483648), (_e1946 < -2147483600f)), 2147483647i, (_e1946 > 2147483500f)), (_e1946 == _e1946));
let _e1957 = (_e1953 - select(0i, 1i, (_e1946 < f32(_e1953))));
let _e1958 = (262147i + _e1957);
let _e1960 = select(_e1755, _e1958, (_e1958 < _e1755));
let _e1966 = global_4.member[bitcast<u32>(select(0i, _e1960, (_e1960 > 0i)))];
let _e1981 = ((_e1790 + (f32(bitcast<i32>((_e1966 >> bitcast<u32>(12u)))) * _e1799)) + ((f32((bitcast<i32>((_e1966 & 4095u)) - 2048i)) * _e1780) * (_e1942 - f32(_e1957))));
let _e1982 = (_e1729 * 1024f);
let _e1984 = select(0f, _e1982, (_e1982 > 0f));
let _e1986 = select(_e1737, _e1984, (_e1984 < _e1737));
let _e1993 = select(0i, select(select(i32(_e1986), i32(-2147483648), (_e1986 < -2147483600f)), 2147483647i, (_e1986 > 2147483500f)), (_e1986 == _e1986));
let _e1997 = (_e1993 - select(0i, 1i, (_e1986 < f32(_e1993))));
let _e1998 = (262147i + _e1997);
let _e2000 = select(_e1755, _e1998, (_e1998 < _e1755));
let _e2006 = global_4.member[bitcast<u32>(select(0i, _e2000, (_e2000 > 0i)))];
let _e2021 = ((_e1790 + (f32(bitcast<i32>((_e2006 >> bitcast<u32>(12u)))) * _e1799)) + ((f32((bitcast<i32>((_e2006 & 4095u)) - 2048i)) * _e1780) * (_e1982 - f32(_e1997))));
let _e2022 = (_e1735 * 1024f);
let _e2024 = select(0f, _e2022, (_e2022 > 0f));
let _e2026 = select(_e1737, _e2024, (_e2024 < _e1737));
let _e2033 = select(0i, select(select(i32(_e2026), i32(-2147483648), (_e2026 < -2147483600f)), 2147483647i, (_e2026 > 2147483500f)), (_e2026 == _e2026));
let _e2037 = (_e2033 - select(0i, 1i, (_e2026 < f32(_e2033))));
let _e2038 = (262147i + _e2037);
let _e2040 = select(_e1755, _e2038, (_e2038 < _e1755));
let _e2046 = global_4.member[bitcast<u32>(select(0i, _e2040, (_e2040 > 0i)))];
let _e2061 = ((_e1790 + (f32(bitcast<i32>((_e2046 >> bitcast<u32>(12u)))) * _e1799)) + ((f32((bitcast<i32>((_e2046 & 4095u)) - 2048i)) * _e1780) * (_e2022 - f32(_e2037))));
let _e2062 = (_e1901 - _e1861);
let _e2064 = (_e1981 - _e1941);
let _e2066 = (_e2061 - _e2021);
phi_3409_ = type_29(_e1805, vec3<f32>((0.5f * _e2062), (0.5f * _e2064), (0.5f * _e2066)), vec3<f32>((0.25f * (_e2062 * (_e1901 + _e1861))), (0.25f * (_e2064 * (_e1981 + _e1941))), (0.25f * (_e2066 * (_e2061 + _e2021)))));
}
let _e2081 = phi_3409_;
let _e2096 = select(0f, 1f, ((((((_e702 >= -0.5f) && (_e702 <= _e725)) && (_e708 >= -0.5f)) && (_e708 <= _e735)) && (_e714 >= -0.5f)) && (_e714 <= _e745)));
let _e2098 = (0.5f * (_e1711 - _e1705));
let _e2100 = (0.5f * (_e1723 - _e1717));
let _e2102 = (0.5f * (_e1735 - _e1729));
let _e2108 = global_1.member.member_6.member.member.member;
let _e2114 = global_1.member.member_6.member.member.member_1;
let _e2120 = global_1.member.member_6.member.member.member_2;
let _e2126 = global_1.member.member_6.member_1.member.member;
let _e2132 = global_1.member.member_6.member_1.member.member_1;
let _e2138 = global_1.member.member_6.member_1.member.member_2;
let _e2144 = global_1.member.member_6.member_2.member.member;
let _e2150 = global_1.member.member_6.member_2.member.member_1;
let _e2156 = global_1.member.member_6.member_2.member.member_2;
phi_4171_ = type_30(_e1699, vec3<f32>(((((_e2108 * _e2098) + (_e2126 * _e2100)) + (_e2144 * _e2102)) * _e2096), ((((_e2114 * _e2098) + (_e2132 * _e2100)) + (_e2150 * _e2102)) * _e2096), ((((_e2120 * _e2098) + (_e2138 * _e2100)) + (_e2156 * _e2102)) * _e2096)), _e2081.member, vec3<f32>(((((_e2108 * _e2081.member_2.x) + (_e2126 * _e2081.member_2.y)) + (_e2144 * _e2081.member_2.z)) * _e2096), ((((_e2114 * _e2081.member_2.x) + (_e2132 * _e2081.member_2.y)) + (_e2150 * _e2081.member_2.z)) * _e2096), ((((_e2120 * _e2081.member_2.x) + (_e2138 * _e2081.member_2.y)) + (_e2156 * _e2081.member_2.z)) * _e2096)), vec3<f32>(((((_e2108 * _e2081.member_1.x) + (_e2126 * _e2081.member_1.y)) + (_e2144 * _e2081.member_1.z)) * _e2096), ((((_e2114 * _e2081.member_1.x) + (_e2132 * _e2081.member_1.y)) + (_e2150 * _e2081.member_1.z)) * _e2096), ((((_e2120 * _e2081.member_1.x) + (_e2138 * _e2081.member_1.y)) + (_e2156 * _e2081.member_1.z)) * _e2096)));
} else {
let _e2225 = global_1.member.member_6.member_3.member;
let _e2226 = (_e2225 - 0.5f);
let _e2228 = select(-0.5f, _e702, (_e702 > -0.5f));
let _e2230 = select(_e2226, _e2228, (_e2228 < _e2226));
let _e2235 = global_1.member.member_6.member_3.member_1;
let _e2236 = (_e2235 - 0.5f);
let _e2238 = select(-0.5f, _e708, (_e708 > -0.5f));
let _e2240 = select(_e2236, _e2238, (_e2238 < _e2236));
let _e2245 = global_1.member.member_6.member_3.member_2;
let _e2246 = (_e2245 - 0.5f);
let _e2248 = select(-0.5f, _e714, (_e714 > -0.5f));
let _e2250 = select(_e2246, _e2248, (_e2248 < _e2246));
let _e2252 = select(-1f, _e2230, (_e2230 > -1f));
let _e2254 = select(_e2225, _e2252, (_e2252 < _e2225));
let _e2261 = select(0i, select(select(i32(_e2254), i32(-2147483648), (_e2254 < -2147483600f)), 2147483647i, (_e2254 > 2147483500f)), (_e2254 == _e2254));
let _e2265 = (_e2261 - select(0i, 1i, (_e2254 < f32(_e2261))));
let _e2267 = select(-1f, _e2240, (_e2240 > -1f));
let _e2269 = select(_e2235, _e2267, (_e2267 < _e2235));
let _e2276 = select(0i, select(select(i32(_e2269), i32(-2147483648), (_e2269 < -2147483600f)), 2147483647i, (_e2269 > 2147483500f)), (_e2269 == _e2269));
let _e2280 = (_e2276 - select(0i, 1i, (_e2269 < f32(_e2276))));
let _e2282 = select(-1f, _e2250, (_e2250 > -1f));
let _e2284 = select(_e2245, _e2282, (_e2282 < _e2245));
let _e2291 = select(0i, select(select(i32(_e2284), i32(-2147483648), (_e2284 < -2147483600f)), 2147483647i, (_e2284 > 2147483500f)), (_e2284 == _e2284));
let _e2295 = (_e2291 - select(0i, 1i, (_e2284 < f32(_e2291))));
let _e2299 = global_1.member.member_6.member_7;
let _e2303 = global_1.member.member_6.member_8;
let _e2311 = (select(0i, select(select(i32(_e2235), i32(-2147483648), (_e2235 < -2147483600f)), 2147483647i, (_e2235 > 2147483500f)), (_e2235 == _e2235)) - 1i);
let _e2314 = (_e2280 + 1i);
let _e2324 = (select(0i, select(select(i32(_e2245), i32(-2147483648), (_e2245 < -2147483600f)), 2147483647i, (_e2245 > 2147483500f)), (_e2245 == _e2245)) - 1i);
let _e2327 = (_e2295 + 1i);
let _e2336 = select(0i, select(select(i32(_e2225), i32(-2147483648), (_e2225 < -2147483600f)), 2147483647i, (_e2225 > 2147483500f)), (_e2225 == _e2225));
let _e2337 = (_e2336 - 1i);
let _e2338 = (_e2265 - 1i);
let _e2340 = select(0i, _e2338, (_e2338 > 0i));
let _e2343 = (_e2265 + 1i);
let _e2346 = (_e2265 + 2i);
let _e2349 = (_e2336 - 4i);
let _e2351 = select(0i, _e2349, (_e2349 > 0i));
let _e2353 = select(_e2351, _e2340, (_e2340 < _e2351));
let _e2366 = (select(0i, _e2280, (_e2280 > 0i)) * _e2299);
let _e2367 = (select(_e2311, _e2314, (_e2314 < _e2311)) * _e2299);
let _e2368 = (select(0i, _e2295, (_e2295 > 0i)) * _e2303);
let _e2369 = (select(_e2324, _e2327, (_e2327 < _e2324)) * _e2303);
local_2 = type_28(array<i32, 4>(_e2353, _e2353, _e2353, _e2353), array<u32, 6>(bitcast<u32>(((_e2340 - _e2353) * 8i)), bitcast<u32>(((select(0i, _e2265, (_e2265 > 0i)) - _e2353) * 8i)), bitcast<u32>(((select(_e2337, _e2343, (_e2343 < _e2337)) - _e2353) * 8i)), bitcast<u32>(((select(_e2337, _e2346, (_e2346 < _e2337)) - _e2353) * 8i)), 0u, 0u));
local_3 = vec3<f32>((_e2230 - f32(_e2265)), (_e2240 - f32(_e2280)), (_e2250 - f32(_e2295)));
let _e2384 = local_2.member[0u];
let _e2385 = ((_e2368 + _e2366) + _e2384);
let _e2387 = (_e2385 >> bitcast<u32>(2i));
let _e2390 = bitcast<u32>(((_e2385 & 3i) * 8i));
let _e2392 = (bitcast<i32>(_e88) - 1i);
let _e2394 = select(_e2392, _e2387, (_e2387 < _e2392));
let _e2399 = global_2.member[bitcast<u32>(select(0i, _e2394, (_e2394 > 0i)))];
let _e2403 = (_e2387 + 1i);
let _e2405 = select(_e2392, _e2403, (_e2403 < _e2392));
let _e2410 = global_2.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2417 = ((_e2399 >> bitcast<u32>((_e2390 & 31u))) | ((_e2410 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2390) & 31u))));
let _e2420 = local_2.member_1[1u];
let _e2426 = f32(bitcast<i32>(((_e2417 >> bitcast<u32>((_e2420 & 31u))) & 255u)));
let _e2429 = local_2.member_1[2u];
let _e2436 = local_3[0u];
let _e2439 = (_e2426 + ((f32(bitcast<i32>(((_e2417 >> bitcast<u32>((_e2429 & 31u))) & 255u))) - _e2426) * _e2436));
let _e2441 = local_2.member[0u];
let _e2442 = ((_e2368 + _e2367) + _e2441);
let _e2444 = (_e2442 >> bitcast<u32>(2i));
let _e2447 = bitcast<u32>(((_e2442 & 3i) * 8i));
let _e2449 = select(_e2392, _e2444, (_e2444 < _e2392));
let _e2454 = global_2.member[bitcast<u32>(select(0i, _e2449, (_e2449 > 0i)))];
let _e2458 = (_e2444 + 1i);
let _e2460 = select(_e2392, _e2458, (_e2458 < _e2392));
let _e2465 = global_2.member[bitcast<u32>(select(0i, _e2460, (_e2460 > 0i)))];
let _e2472 = ((_e2454 >> bitcast<u32>((_e2447 & 31u))) | ((_e2465 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2447) & 31u))));
let _e2473 = local_2.member_1[1u];
let _e2479 = f32(bitcast<i32>(((_e2472 >> bitcast<u32>((_e2473 & 31u))) & 255u)));
let _e2480 = local_2.member_1[2u];
let _e2487 = local_3[0u];
let _e2492 = local_3[1u];
let _e2495 = (_e2439 + (((_e2479 + ((f32(bitcast<i32>(((_e2472 >> bitcast<u32>((_e2480 & 31u))) & 255u))) - _e2479) * _e2487)) - _e2439) * _e2492));
let _e2497 = local_2.member[0u];
let _e2498 = ((_e2369 + _e2366) + _e2497);
let _e2500 = (_e2498 >> bitcast<u32>(2i));
let _e2503 = bitcast<u32>(((_e2498 & 3i) * 8i));
let _e2505 = select(_e2392, _e2500, (_e2500 < _e2392));
let _e2510 = global_2.member[bitcast<u32>(select(0i, _e2505, (_e2505 > 0i)))];
let _e2514 = (_e2500 + 1i);
let _e2516 = select(_e2392, _e2514, (_e2514 < _e2392));
let _e2521 = global_2.member[bitcast<u32>(select(0i, _e2516, (_e2516 > 0i)))];
let _e2528 = ((_e2510 >> bitcast<u32>((_e2503 & 31u))) | ((_e2521 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2503) & 31u))));
let _e2529 = local_2.member_1[1u];
let _e2535 = f32(bitcast<i32>(((_e2528 >> bitcast<u32>((_e2529 & 31u))) & 255u)));
let _e2536 = local_2.member_1[2u];
let _e2543 = local_3[0u];
let _e2546 = (_e2535 + ((f32(bitcast<i32>(((_e2528 >> bitcast<u32>((_e2536 & 31u))) & 255u))) - _e2535) * _e2543));
let _e2548 = local_2.member[0u];
let _e2549 = ((_e2369 + _e2367) + _e2548);
let _e2551 = (_e2549 >> bitcast<u32>(2i));
let _e2554 = bitcast<u32>(((_e2549 & 3i) * 8i));
let _e2556 = select(_e2392, _e2551, (_e2551 < _e2392));
let _e2561 = global_2.member[bitcast<u32>(select(0i, _e2556, (_e2556 > 0i)))];
let _e2565 = (_e2551 + 1i);
let _e2567 = select(_e2392, _e2565, (_e2565 < _e2392));
let _e2572 = global_2.member[bitcast<u32>(select(0i, _e2567, (_e2567 > 0i)))];
let _e2579 = ((_e2561 >> bitcast<u32>((_e2554 & 31u))) | ((_e2572 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2554) & 31u))));
let _e2580 = local_2.member_1[1u];
let _e2586 = f32(bitcast<i32>(((_e2579 >> bitcast<u32>((_e2580 & 31u))) & 255u)));
let _e2587 = local_2.member_1[2u];
let _e2594 = local_3[0u];
let _e2598 = local_3[1u];
let _e2603 = local_3[2u];
let _e2610 = global_1.member.member_6.member_5;
let _e2615 = global_1.member.member_6.member_6;
let _e2616 = (((_e2495 + (((_e2546 + (((_e2586 + ((f32(bitcast<i32>(((_e2579 >> bitcast<u32>((_e2587 & 31u))) & 255u))) - _e2586) * _e2594)) - _e2546) * _e2598)) - _e2495) * _e2603)) * _e2610) + _e2615);
let _e2618 = select(0f, _e2616, (_e2616 > 0f));
phi_4171_ = type_30(select(1f, _e2618, (_e2618 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2623 = phi_4171_;
let _e2628 = global_1.member.member_6.member_3.member;
let _e2629 = (_e2628 - 0.5f);
let _e2631 = select(-0.5f, _e666, (_e666 > -0.5f));
let _e2633 = select(_e2629, _e2631, (_e2631 < _e2629));
let _e2638 = global_1.member.member_6.member_3.member_1;
let _e2639 = (_e2638 - 0.5f);
let _e2641 = select(-0.5f, _e681, (_e681 > -0.5f));
let _e2643 = select(_e2639, _e2641, (_e2641 < _e2639));
let _e2648 = global_1.member.member_6.member_3.member_2;
let _e2649 = (_e2648 - 0.5f);
let _e2651 = select(-0.5f, _e696, (_e696 > -0.5f));
let _e2653 = select(_e2649, _e2651, (_e2651 < _e2649));
let _e2655 = select(-1f, _e2633, (_e2633 > -1f));
let _e2657 = select(_e2628, _e2655, (_e2655 < _e2628));
let _e2664 = select(0i, select(select(i32(_e2657), i32(-2147483648), (_e2657 < -2147483600f)), 2147483647i, (_e2657 > 2147483500f)), (_e2657 == _e2657));
let _e2668 = (_e2664 - select(0i, 1i, (_e2657 < f32(_e2664))));
let _e2670 = select(-1f, _e2643, (_e2643 > -1f));
let _e2672 = select(_e2638, _e2670, (_e2670 < _e2638));
let _e2679 = select(0i, select(select(i32(_e2672), i32(-2147483648), (_e2672 < -2147483600f)), 2147483647i, (_e2672 > 2147483500f)), (_e2672 == _e2672));
let _e2683 = (_e2679 - select(0i, 1i, (_e2672 < f32(_e2679))));
let _e2685 = select(-1f, _e2653, (_e2653 > -1f));
let _e2687 = select(_e2648, _e2685, (_e2685 < _e2648));
let _e2694 = select(0i, select(select(i32(_e2687), i32(-2147483648), (_e2687 < -2147483600f)), 2147483647i, (_e2687 > 2147483500f)), (_e2687 == _e2687));
let _e2698 = (_e2694 - select(0i, 1i, (_e2687 < f32(_e2694))));
let _e2702 = global_1.member.member_6.member_7;
let _e2706 = global_1.member.member_6.member_8;
let _e2714 = (select(0i, select(select(i32(_e2638), i32(-2147483648), (_e2638 < -2147483600f)), 2147483647i, (_e2638 > 2147483500f)), (_e2638 == _e2638)) - 1i);
let _e2717 = (_e2683 + 1i);
let _e2727 = (select(0i, select(select(i32(_e2648), i32(-2147483648), (_e2648 < -2147483600f)), 2147483647i, (_e2648 > 2147483500f)), (_e2648 == _e2648)) - 1i);
let _e2730 = (_e2698 + 1i);
let _e2739 = select(0i, select(select(i32(_e2628), i32(-2147483648), (_e2628 < -2147483600f)), 2147483647i, (_e2628 > 2147483500f)), (_e2628 == _e2628));
let _e2740 = (_e2739 - 1i);
let _e2741 = (_e2668 - 1i);
let _e2743 = select(0i, _e2741, (_e2741 > 0i));
let _e2746 = (_e2668 + 1i);
let _e2749 = (_e2668 + 2i);
let _e2752 = (_e2739 - 4i);
let _e2754 = select(0i, _e2752, (_e2752 > 0i));
let _e2756 = select(_e2754, _e2743, (_e2743 < _e2754));
let _e2769 = (select(0i, _e2683, (_e2683 > 0i)) * _e2702);
let _e2770 = (select(_e2714, _e2717, (_e2717 < _e2714)) * _e2702);
let _e2771 = (select(0i, _e2698, (_e2698 > 0i)) * _e2706);
let _e2772 = (select(_e2727, _e2730, (_e2730 < _e2727)) * _e2706);
local = type_28(array<i32, 4>(_e2756, _e2756, _e2756, _e2756), array<u32, 6>(bitcast<u32>(((_e2743 - _e2756) * 8i)), bitcast<u32>(((select(0i, _e2668, (_e2668 > 0i)) - _e2756) * 8i)), bitcast<u32>(((select(_e2740, _e2746, (_e2746 < _e2740)) - _e2756) * 8i)), bitcast<u32>(((select(_e2740, _e2749, (_e2749 < _e2740)) - _e2756) * 8i)), 0u, 0u));
local_1 = vec3<f32>((_e2633 - f32(_e2668)), (_e2643 - f32(_e2683)), (_e2653 - f32(_e2698)));
let _e2787 = local.member[0u];
let _e2788 = ((_e2771 + _e2769) + _e2787);
let _e2790 = (_e2788 >> bitcast<u32>(2i));
let _e2793 = bitcast<u32>(((_e2788 & 3i) * 8i));
let _e2795 = (bitcast<i32>(_e88) - 1i);
let _e2797 = select(_e2795, _e2790, (_e2790 < _e2795));
let _e2802 = global_2.member[bitcast<u32>(select(0i, _e2797, (_e2797 > 0i)))];
let _e2806 = (_e2790 + 1i);
let _e2808 = select(_e2795, _e2806, (_e2806 < _e2795));
let _e2813 = global_2.member[bitcast<u32>(select(0i, _e2808, (_e2808 > 0i)))];
let _e2820 = ((_e2802 >> bitcast<u32>((_e2793 & 31u))) | ((_e2813 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2793) & 31u))));
let _e2823 = local.member_1[1u];
let _e2829 = f32(bitcast<i32>(((_e2820 >> bitcast<u32>((_e2823 & 31u))) & 255u)));
let _e2832 = local.member_1[2u];
let _e2839 = local_1[0u];
let _e2842 = (_e2829 + ((f32(bitcast<i32>(((_e2820 >> bitcast<u32>((_e2832 & 31u))) & 255u))) - _e2829) * _e2839));
let _e2844 = local.member[0u];
let _e2845 = ((_e2771 + _e2770) + _e2844);
let _e2847 = (_e2845 >> bitcast<u32>(2i));
let _e2850 = bitcast<u32>(((_e2845 & 3i) * 8i));
let _e2852 = select(_e2795, _e2847, (_e2847 < _e2795));
let _e2857 = global_2.member[bitcast<u32>(select(0i, _e2852, (_e2852 > 0i)))];
let _e2861 = (_e2847 + 1i);
let _e2863 = select(_e2795, _e2861, (_e2861 < _e2795));
let _e2868 = global_2.member[bitcast<u32>(select(0i, _e2863, (_e2863 > 0i)))];
let _e2875 = ((_e2857 >> bitcast<u32>((_e2850 & 31u))) | ((_e2868 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2850) & 31u))));
let _e2876 = local.member_1[1u];
let _e2882 = f32(bitcast<i32>(((_e2875 >> bitcast<u32>((_e2876 & 31u))) & 255u)));
let _e2883 = local.member_1[2u];
let _e2890 = local_1[0u];
let _e2895 = local_1[1u];
let _e2898 = (_e2842 + (((_e2882 + ((f32(bitcast<i32>(((_e2875 >> bitcast<u32>((_e2883 & 31u))) & 255u))) - _e2882) * _e2890)) - _e2842) * _e2895));
let _e2900 = local.member[0u];
let _e2901 = ((_e2772 + _e2769) + _e2900);
let _e2903 = (_e2901 >> bitcast<u32>(2i));
let _e2906 = bitcast<u32>(((_e2901 & 3i) * 8i));
let _e2908 = select(_e2795, _e2903, (_e2903 < _e2795));
let _e2913 = global_2.member[bitcast<u32>(select(0i, _e2908, (_e2908 > 0i)))];
let _e2917 = (_e2903 + 1i);
let _e2919 = select(_e2795, _e2917, (_e2917 < _e2795));
let _e2924 = global_2.member[bitcast<u32>(select(0i, _e2919, (_e2919 > 0i)))];
let _e2931 = ((_e2913 >> bitcast<u32>((_e2906 & 31u))) | ((_e2924 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2906) & 31u))));
let _e2932 = local.member_1[1u];
let _e2938 = f32(bitcast<i32>(((_e2931 >> bitcast<u32>((_e2932 & 31u))) & 255u)));
let _e2939 = local.member_1[2u];
let _e2946 = local_1[0u];
let _e2949 = (_e2938 + ((f32(bitcast<i32>(((_e2931 >> bitcast<u32>((_e2939 & 31u))) & 255u))) - _e2938) * _e2946));
let _e2951 = local.member[0u];
let _e2952 = ((_e2772 + _e2770) + _e2951);
let _e2954 = (_e2952 >> bitcast<u32>(2i));
let _e2957 = bitcast<u32>(((_e2952 & 3i) * 8i));
let _e2959 = select(_e2795, _e2954, (_e2954 < _e2795));
let _e2964 = global_2.member[bitcast<u32>(select(0i, _e2959, (_e2959 > 0i)))];
let _e2968 = (_e2954 + 1i);
let _e2970 = select(_e2795, _e2968, (_e2968 < _e2795));
let _e2975 = global_2.member[bitcast<u32>(select(0i, _e2970, (_e2970 > 0i)))];
let _e2982 = ((_e2964 >> bitcast<u32>((_e2957 & 31u))) | ((_e2975 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2957) & 31u))));
let _e2983 = local.member_1[1u];
let _e2989 = f32(bitcast<i32>(((_e2982 >> bitcast<u32>((_e2983 & 31u))) & 255u)));
let _e2990 = local.member_1[2u];
let _e2997 = local_1[0u];
let _e3001 = local_1[1u];
let _e3006 = local_1[2u];
let _e3013 = global_1.member.member_6.member_5;
let _e3018 = global_1.member.member_6.member_6;
let _e3019 = (((_e2898 + (((_e2949 + (((_e2989 + ((f32(bitcast<i32>(((_e2982 >> bitcast<u32>((_e2990 & 31u))) & 255u))) - _e2989) * _e2997)) - _e2949) * _e3001)) - _e2898) * _e3006)) * _e3013) + _e3018);
let _e3021 = select(0f, _e3019, (_e3019 > 0f));
let _e3023 = select(1f, _e3021, (_e3021 < 1f));
let _e3026 = global_1.member.member_1;
if ((_e3026 & 16u) == 0u) {
phi_5120_ = type_5(1f, 1f, 1f);
} else {
let _e3032 = global_1.member.member_14.member;
let _e3043 = ((((_e3032.member.member * _e623) + (_e3032.member.member_1 * _e636)) + (_e3032.member.member_2 * _e601)) + _e3032.member_1);
let _e3049 = ((((_e3032.member.member * _e646) + (_e3032.member.member_1 * _e651)) + (_e3032.member.member_2 * _e640)) + _e3032.member_1);
let _e3051 = select(_e3049, _e3043, (_e3043 < _e3049));
let _e3053 = select(_e3049, _e3043, (_e3043 > _e3049));
let _e3055 = (_e3053 - _e3051);
let _e3058 = (-(_e3051) / select(1e-30f, _e3055, (_e3055 > 1e-30f)));
let _e3060 = select(0f, _e3058, (_e3058 > 0f));
let _e3066 = select(select(select(1f, _e3060, (_e3060 < 1f)), 1f, (_e3053 <= 0f)), 0f, (_e3051 > 0f));
let _e3071 = global_1.member.member_14.member_1;
let _e3072 = (_e3071 != 0u);
let _e3082 = global_1.member.member_15.member;
let _e3093 = ((((_e3082.member.member * _e623) + (_e3082.member.member_1 * _e636)) + (_e3082.member.member_2 * _e601)) + _e3082.member_1);
let _e3099 = ((((_e3082.member.member * _e646) + (_e3082.member.member_1 * _e651)) + (_e3082.member.member_2 * _e640)) + _e3082.member_1);
let _e3101 = select(_e3099, _e3093, (_e3093 < _e3099));
let _e3103 = select(_e3099, _e3093, (_e3093 > _e3099));
let _e3105 = (_e3103 - _e3101);
let _e3108 = (-(_e3101) / select(1e-30f, _e3105, (_e3105 > 1e-30f)));
let _e3110 = select(0f, _e3108, (_e3108 > 0f));
let _e3116 = select(select(select(1f, _e3110, (_e3110 < 1f)), 1f, (_e3103 <= 0f)), 0f, (_e3101 > 0f));
let _e3121 = global_1.member.member_15.member_1;
let _e3122 = (_e3121 != 0u);
let _e3132 = global_1.member.member_16.member;
let _e3143 = ((((_e3132.member.member * _e623) + (_e3132.member.member_1 * _e636)) + (_e3132.member.member_2 * _e601)) + _e3132.member_1);
let _e3149 = ((((_e3132.member.member * _e646) + (_e3132.member.member_1 * _e651)) + (_e3132.member.member_2 * _e640)) + _e3132.member_1);
let _e3151 = select(_e3149, _e3143, (_e3143 < _e3149));
let _e3153 = select(_e3149, _e3143, (_e3143 > _e3149));
let _e3155 = (_e3153 - _e3151);
let _e3158 = (-(_e3151) / select(1e-30f, _e3155, (_e3155 > 1e-30f)));
let _e3160 = select(0f, _e3158, (_e3158 > 0f));
let _e3166 = select(select(select(1f, _e3160, (_e3160 < 1f)), 1f, (_e3153 <= 0f)), 0f, (_e3151 > 0f));
let _e3171 = global_1.member.member_16.member_1;
let _e3172 = (_e3171 != 0u);
let _e3182 = global_1.member.member_17.member;
let _e3193 = ((((_e3182.member.member * _e623) + (_e3182.member.member_1 * _e636)) + (_e3182.member.member_2 * _e601)) + _e3182.member_1);
let _e3199 = ((((_e3182.member.member * _e646) + (_e3182.member.member_1 * _e651)) + (_e3182.member.member_2 * _e640)) + _e3182.member_1);
let _e3201 = select(_e3199, _e3193, (_e3193 < _e3199));
let _e3203 = select(_e3199, _e3193, (_e3193 > _e3199));
let _e3205 = (_e3203 - _e3201);
let _e3208 = (-(_e3201) / select(1e-30f, _e3205, (_e3205 > 1e-30f)));
let _e3210 = select(0f, _e3208, (_e3208 > 0f));
let _e3216 = select(select(select(1f, _e3210, (_e3210 < 1f)), 1f, (_e3203 <= 0f)), 0f, (_e3201 > 0f));
let _e3221 = global_1.member.member_17.member_1;
let _e3222 = (_e3221 != 0u);
phi_5120_ = type_5(((((1f * _e3066) * _e3116) * _e3166) * _e3216), ((((1f * select(1f, _e3066, _e3072)) * select(1f, _e3116, _e3122)) * select(1f, _e3166, _e3172)) * select(1f, _e3216, _e3222)), ((((1f * select(1f, 0f, (_e3072 && (_e3049 > 0f)))) * select(1f, 0f, (_e3122 && (_e3099 > 0f)))) * select(1f, 0f, (_e3172 && (_e3149 > 0f)))) * select(1f, 0f, (_e3222 && (_e3199 > 0f)))));
}
let _e3231 = phi_5120_;
let _e3232 = (_e702 - _e666);
let _e3236 = (bitcast<f32>((bitcast<u32>(_e3232) & 2147483647u)) < 1e-12f);
let _e3238 = (1f / select(_e3232, 1f, _e3236));
let _e3240 = ((-0.5f - _e666) * _e3238);
let _e3242 = ((_e2629 - _e666) * _e3238);
let _e3248 = select(_e3242, _e3240, (_e3240 < _e3242));
let _e3250 = select(0f, _e3248, (_e3248 > 0f));
let _e3253 = select(select(1f, _e3250, (_e3250 < 1f)), select(2f, 0f, ((_e666 >= -0.5f) && (_e666 <= _e2629))), _e3236);
let _e3255 = select(_e3242, _e3240, (_e3240 > _e3242));
let _e3257 = select(0f, _e3255, (_e3255 > 0f));
let _e3260 = select(select(1f, _e3257, (_e3257 < 1f)), 1f, _e3236);
let _e3261 = (_e708 - _e681);
let _e3265 = (bitcast<f32>((bitcast<u32>(_e3261) & 2147483647u)) < 1e-12f);
let _e3267 = (1f / select(_e3261, 1f, _e3265));
let _e3269 = ((-0.5f - _e681) * _e3267);
let _e3271 = ((_e2639 - _e681) * _e3267);
let _e3277 = select(_e3271, _e3269, (_e3269 < _e3271));
let _e3279 = select(0f, _e3277, (_e3277 > 0f));
let _e3282 = select(select(1f, _e3279, (_e3279 < 1f)), select(2f, 0f, ((_e681 >= -0.5f) && (_e681 <= _e2639))), _e3265);
let _e3284 = select(_e3271, _e3269, (_e3269 > _e3271));
let _e3286 = select(0f, _e3284, (_e3284 > 0f));
let _e3289 = select(select(1f, _e3286, (_e3286 < 1f)), 1f, _e3265);
let _e3290 = (_e714 - _e696);
let _e3294 = (bitcast<f32>((bitcast<u32>(_e3290) & 2147483647u)) < 1e-12f);
let _e3296 = (1f / select(_e3290, 1f, _e3294));
let _e3298 = ((-0.5f - _e696) * _e3296);
let _e3300 = ((_e2649 - _e696) * _e3296);
let _e3306 = select(_e3300, _e3298, (_e3298 < _e3300));
let _e3308 = select(0f, _e3306, (_e3306 > 0f));
let _e3311 = select(select(1f, _e3308, (_e3308 < 1f)), select(2f, 0f, ((_e696 >= -0.5f) && (_e696 <= _e2649))), _e3294);
let _e3313 = select(_e3300, _e3298, (_e3298 > _e3300));
let _e3315 = select(0f, _e3313, (_e3313 > 0f));
let _e3318 = select(select(1f, _e3315, (_e3315 < 1f)), 1f, _e3294);
let _e3320 = select(_e3289, _e3260, (_e3260 < _e3289));
let _e3324 = select(_e3282, _e3253, (_e3253 > _e3282));
let _e3327 = (select(_e3318, _e3320, (_e3320 < _e3318)) - select(_e3311, _e3324, (_e3324 > _e3311)));
let _e3330 = (_e646 - _e623);
let _e3331 = (_e651 - _e636);
let _e3332 = (_e640 - _e601);
let _e3337 = (((_e3330 * _e3330) + (_e3331 * _e3331)) + (_e3332 * _e3332));
let _e3345 = global_1.member.member_5.member_3;
let _e3346 = ((sqrt(select(0f, _e3337, (_e3337 > 0f))) * select(0f, _e3327, (_e3327 > 0f))) * _e3345);
if (_e102.member_2 >= 3u) {
let _e3349 = (_e3023 * 255f);
let _e3350 = (_e2623.member * 255f);
let _e3351 = (255f - 1f);
let _e3353 = select(0f, _e3349, (_e3349 > 0f));
let _e3355 = select(_e3351, _e3353, (_e3353 < _e3351));
let _e3362 = select(0i, select(select(i32(_e3355), i32(-2147483648), (_e3355 < -2147483600f)), 2147483647i, (_e3355 > 2147483500f)), (_e3355 == _e3355));
let _e3366 = (_e3362 - select(0i, 1i, (_e3355 < f32(_e3362))));
let _e3368 = select(0f, _e3350, (_e3350 > 0f));
let _e3370 = select(_e3351, _e3368, (_e3368 < _e3351));
let _e3377 = select(0i, select(select(i32(_e3370), i32(-2147483648), (_e3370 < -2147483600f)), 2147483647i, (_e3370 > 2147483500f)), (_e3370 == _e3370));
let _e3381 = (_e3377 - select(0i, 1i, (_e3370 < f32(_e3377))));
let _e3384 = (((_e3366 * 256i) + _e3381) * 4i);
let _e3388 = (_e3350 - f32(_e3381));
let _e3390 = (bitcast<i32>(_e92) - 1i);
let _e3392 = select(_e3390, _e3384, (_e3384 < _e3390));
let _e3398 = global_4.member[bitcast<u32>(select(0i, _e3392, (_e3392 > 0i)))];
let _e3399 = (_e3384 + 4i);
let _e3401 = select(_e3390, _e3399, (_e3399 < _e3390));
let _e3407 = global_4.member[bitcast<u32>(select(0i, _e3401, (_e3401 > 0i)))];
let _e3408 = (_e3384 + 1024i);
let _e3410 = select(_e3390, _e3408, (_e3408 < _e3390));
let _e3416 = global_4.member[bitcast<u32>(select(0i, _e3410, (_e3410 > 0i)))];
let _e3417 = (_e3384 + 1028i);
let _e3419 = select(_e3390, _e3417, (_e3417 < _e3390));
let _e3425 = global_4.member[bitcast<u32>(select(0i, _e3419, (_e3419 > 0i)))];
let _e3430 = (bitcast<f32>(((_e3398 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3438 = (_e3430 + (((bitcast<f32>(((_e3407 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3430) * _e3388));
let _e3443 = (bitcast<f32>(((_e3416 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3454 = (_e3438 + (((_e3443 + (((bitcast<f32>(((_e3425 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3443) * _e3388)) - _e3438) * (_e3349 - f32(_e3366))));
let _e3458 = -((_e3454 * (_e3346 * _e3231.member)));
let _e3460 = select(-87f, _e3458, (_e3458 > -87f));
let _e3462 = select(88f, _e3460, (_e3460 < 88f));
let _e3464 = ((_e3462 * 1.442695f) + 0.5f);
let _e3466 = select(-127f, _e3464, (_e3464 > -127f));
let _e3468 = select(128f, _e3466, (_e3466 < 128f));
let _e3475 = select(0i, select(select(i32(_e3468), i32(-2147483648), (_e3468 < -2147483600f)), 2147483647i, (_e3468 > 2147483500f)), (_e3468 == _e3468));
let _e3479 = (_e3475 - select(0i, 1i, (_e3468 < f32(_e3475))));
let _e3480 = f32(_e3479);
let _e3484 = ((_e3462 - (_e3480 * 0.6933594f)) - (_e3480 * -2.1219444e-4f));
let _e3504 = ((1f + (_e3484 * (1f + (_e3484 * (0.5f + (_e3484 * (0.16666667f + (_e3484 * (0.041666668f + (_e3484 * (0.008333334f + (_e3484 * (0.001388889f + (_e3484 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3479 + 127i)) << bitcast<u32>(23i))));
let _e3505 = (1f - _e3504);
phi_6230_ = type_31(_e3504, _e3505, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3505 / select(1e-12f, _e3454, (_e3454 > 1e-12f))))));
} else {
let _e3513 = (_e3023 * 255f);
let _e3514 = (_e2623.member * 255f);
let _e3515 = (255f - 1f);
let _e3517 = select(0f, _e3513, (_e3513 > 0f));
let _e3519 = select(_e3515, _e3517, (_e3517 < _e3515));
let _e3526 = select(0i, select(select(i32(_e3519), i32(-2147483648), (_e3519 < -2147483600f)), 2147483647i, (_e3519 > 2147483500f)), (_e3519 == _e3519));
let _e3530 = (_e3526 - select(0i, 1i, (_e3519 < f32(_e3526))));
let _e3532 = select(0f, _e3514, (_e3514 > 0f));
let _e3534 = select(_e3515, _e3532, (_e3532 < _e3515));
let _e3541 = select(0i, select(select(i32(_e3534), i32(-2147483648), (_e3534 < -2147483600f)), 2147483647i, (_e3534 > 2147483500f)), (_e3534 == _e3534));
let _e3545 = (_e3541 - select(0i, 1i, (_e3534 < f32(_e3541))));
let _e3548 = (((_e3530 * 256i) + _e3545) * 4i);
let _e3550 = (_e3513 - f32(_e3530));
let _e3552 = (_e3514 - f32(_e3545));
let _e3554 = (bitcast<i32>(_e92) - 1i);
let _e3556 = select(_e3554, _e3548, (_e3548 < _e3554));
let _e3562 = global_4.member[bitcast<u32>(select(0i, _e3556, (_e3556 > 0i)))];
let _e3563 = (_e3548 + 4i);
let _e3565 = select(_e3554, _e3563, (_e3563 < _e3554));
let _e3571 = global_4.member[bitcast<u32>(select(0i, _e3565, (_e3565 > 0i)))];
let _e3572 = (_e3548 + 1024i);
let _e3574 = select(_e3554, _e3572, (_e3572 < _e3554));
let _e3580 = global_4.member[bitcast<u32>(select(0i, _e3574, (_e3574 > 0i)))];
let _e3581 = (_e3548 + 1028i);
let _e3583 = select(_e3554, _e3581, (_e3581 < _e3554));
let _e3589 = global_4.member[bitcast<u32>(select(0i, _e3583, (_e3583 > 0i)))];
let _e3594 = (bitcast<f32>(((_e3562 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3602 = (_e3594 + (((bitcast<f32>(((_e3571 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3594) * _e3552));
let _e3607 = (bitcast<f32>(((_e3580 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3618 = (_e3602 + (((_e3607 + (((bitcast<f32>(((_e3589 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3607) * _e3552)) - _e3602) * _e3550));
let _e3631 = (bitcast<f32>((((_e3562 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3639 = (_e3631 + (((bitcast<f32>((((_e3571 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3631) * _e3552));
let _e3644 = (bitcast<f32>((((_e3580 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3656 = (_e3548 + 1i);
let _e3658 = select(_e3554, _e3656, (_e3656 < _e3554));
let _e3664 = global_4.member[bitcast<u32>(select(0i, _e3658, (_e3658 > 0i)))];
let _e3665 = (_e3548 + 5i);
let _e3667 = select(_e3554, _e3665, (_e3665 < _e3554));
let _e3673 = global_4.member[bitcast<u32>(select(0i, _e3667, (_e3667 > 0i)))];
let _e3674 = (_e3548 + 1025i);
let _e3676 = select(_e3554, _e3674, (_e3674 < _e3554));
let _e3682 = global_4.member[bitcast<u32>(select(0i, _e3676, (_e3676 > 0i)))];
let _e3683 = (_e3548 + 1029i);
let _e3685 = select(_e3554, _e3683, (_e3683 < _e3554));
let _e3691 = global_4.member[bitcast<u32>(select(0i, _e3685, (_e3685 > 0i)))];
let _e3696 = (bitcast<f32>(((_e3664 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3704 = (_e3696 + (((bitcast<f32>(((_e3673 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3696) * _e3552));
let _e3709 = (bitcast<f32>(((_e3682 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3733 = (bitcast<f32>((((_e3664 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3741 = (_e3733 + (((bitcast<f32>((((_e3673 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3733) * _e3552));
let _e3746 = (bitcast<f32>((((_e3682 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3761 = (_e3346 * _e3231.member_1);
let _e3763 = -(((_e3639 + (((_e3644 + (((bitcast<f32>((((_e3589 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3644) * _e3552)) - _e3639) * _e3550)) * _e3761));
let _e3765 = select(-87f, _e3763, (_e3763 > -87f));
let _e3767 = select(88f, _e3765, (_e3765 < 88f));
let _e3769 = ((_e3767 * 1.442695f) + 0.5f);
let _e3771 = select(-127f, _e3769, (_e3769 > -127f));
let _e3773 = select(128f, _e3771, (_e3771 < 128f));
let _e3780 = select(0i, select(select(i32(_e3773), i32(-2147483648), (_e3773 < -2147483600f)), 2147483647i, (_e3773 > 2147483500f)), (_e3773 == _e3773));
let _e3784 = (_e3780 - select(0i, 1i, (_e3773 < f32(_e3780))));
let _e3785 = f32(_e3784);
let _e3789 = ((_e3767 - (_e3785 * 0.6933594f)) - (_e3785 * -2.1219444e-4f));
let _e3811 = -(((_e3704 + (((_e3709 + (((bitcast<f32>(((_e3691 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3709) * _e3552)) - _e3704) * _e3550)) * _e3761));
let _e3813 = select(-87f, _e3811, (_e3811 > -87f));
let _e3815 = select(88f, _e3813, (_e3813 < 88f));
let _e3817 = ((_e3815 * 1.442695f) + 0.5f);
let _e3819 = select(-127f, _e3817, (_e3817 > -127f));
let _e3821 = select(128f, _e3819, (_e3819 < 128f));
let _e3828 = select(0i, select(select(i32(_e3821), i32(-2147483648), (_e3821 < -2147483600f)), 2147483647i, (_e3821 > 2147483500f)), (_e3821 == _e3821));
let _e3832 = (_e3828 - select(0i, 1i, (_e3821 < f32(_e3828))));
let _e3833 = f32(_e3832);
let _e3837 = ((_e3815 - (_e3833 * 0.6933594f)) - (_e3833 * -2.1219444e-4f));
let _e3859 = -(((_e3741 + (((_e3746 + (((bitcast<f32>((((_e3691 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3746) * _e3552)) - _e3741) * _e3550)) * _e3761));
let _e3861 = select(-87f, _e3859, (_e3859 > -87f));
let _e3863 = select(88f, _e3861, (_e3861 < 88f));
let _e3865 = ((_e3863 * 1.442695f) + 0.5f);
let _e3867 = select(-127f, _e3865, (_e3865 > -127f));
let _e3869 = select(128f, _e3867, (_e3867 < 128f));
let _e3876 = select(0i, select(select(i32(_e3869), i32(-2147483648), (_e3869 < -2147483600f)), 2147483647i, (_e3869 > 2147483500f)), (_e3869 == _e3869));
let _e3880 = (_e3876 - select(0i, 1i, (_e3869 < f32(_e3876))));
let _e3881 = f32(_e3880);
let _e3885 = ((_e3863 - (_e3881 * 0.6933594f)) - (_e3881 * -2.1219444e-4f));
let _e3908 = -((_e3618 * (_e3346 * _e3231.member)));
let _e3910 = select(-87f, _e3908, (_e3908 > -87f));
let _e3912 = select(88f, _e3910, (_e3910 < 88f));
let _e3914 = ((_e3912 * 1.442695f) + 0.5f);
let _e3916 = select(-127f, _e3914, (_e3914 > -127f));
let _e3918 = select(128f, _e3916, (_e3916 < 128f));
let _e3925 = select(0i, select(select(i32(_e3918), i32(-2147483648), (_e3918 < -2147483600f)), 2147483647i, (_e3918 > 2147483500f)), (_e3918 == _e3918));
let _e3929 = (_e3925 - select(0i, 1i, (_e3918 < f32(_e3925))));
let _e3930 = f32(_e3929);
let _e3934 = ((_e3912 - (_e3930 * 0.6933594f)) - (_e3930 * -2.1219444e-4f));
let _e3954 = ((1f + (_e3934 * (1f + (_e3934 * (0.5f + (_e3934 * (0.16666667f + (_e3934 * (0.041666668f + (_e3934 * (0.008333334f + (_e3934 * (0.001388889f + (_e3934 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3929 + 127i)) << bitcast<u32>(23i))));
let _e3955 = (1f - _e3954);
phi_6230_ = type_31(_e3954, _e3955, vec3<f32>(((1f + (_e3789 * (1f + (_e3789 * (0.5f + (_e3789 * (0.16666667f + (_e3789 * (0.041666668f + (_e3789 * (0.008333334f + (_e3789 * (0.001388889f + (_e3789 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3784 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3837 * (1f + (_e3837 * (0.5f + (_e3837 * (0.16666667f + (_e3837 * (0.041666668f + (_e3837 * (0.008333334f + (_e3837 * (0.001388889f + (_e3837 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3832 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3885 * (1f + (_e3885 * (0.5f + (_e3885 * (0.16666667f + (_e3885 * (0.041666668f + (_e3885 * (0.008333334f + (_e3885 * (0.001388889f + (_e3885 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3880 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3955 / select(1e-12f, _e3618, (_e3618 > 1e-12f))))));
}
let _e3963 = phi_6230_;
if _e719 {
let _e3967 = global_1.member.member_5.member_2;
let _e3975 = global_1.member.member_5.member_4;
let _e3978 = (_e2623.member_3.x * _e3231.member_2);
let _e3980 = (_e2623.member_3.y * _e3231.member_2);
let _e3982 = (_e2623.member_3.z * _e3231.member_2);
let _e3983 = (0.5f * (_e3967 / select(1e-6f, _e182, (_e182 > 1e-6f))));
let _e3987 = (_e160 + (_e3978 * _e3983));
let _e3988 = (_e171 + (_e3980 * _e3983));
let _e3989 = (_e182 + (_e3982 * _e3983));
let _e3991 = (2f * _e3967);
let _e3993 = ((_e3989 * _e3989) + (_e3991 * _e3982));
let _e3997 = (_e3989 + sqrt(select(0f, _e3993, (_e3993 > 0f))));
let _e4001 = (0.5f * (_e3991 / select(1e-6f, _e3997, (_e3997 > 1e-6f))));
let _e4005 = (_e3987 + (_e3978 * _e4001));
let _e4006 = (_e3988 + (_e3980 * _e4001));
let _e4007 = (_e3989 + (_e3982 * _e4001));
let _e4011 = (_e3975 * _e3975);
let _e4013 = (_e4007 * _e4007);
let _e4021 = (((_e3989 <= 0f) || (_e3993 <= 0f)) || ((_e4007 <= 0f) || (_e4013 <= (_e4011 * (((_e4005 * _e4005) + (_e4006 * _e4006)) + _e4013)))));
let _e4035 = (_e160 + ((_e2623.member_4.x * _e3231.member_2) * _e3967));
let _e4036 = (_e171 + ((_e2623.member_4.y * _e3231.member_2) * _e3967));
let _e4037 = (_e182 + ((_e2623.member_4.z * _e3231.member_2) * _e3967));
let _e4039 = (_e4037 * _e4037);
let _e4048 = ((_e3026 & 1u) != 0u);
let _e4052 = select(_e4021, ((_e4037 <= 0f) || (_e4039 <= (_e4011 * (((_e4035 * _e4035) + (_e4036 * _e4036)) + _e4039)))), _e4048);
phi_6382_ = vec3<f32>(select(select(select(_e4005, _e3987, _e4021), _e4035, _e4048), _e160, _e4052), select(select(select(_e4006, _e3988, _e4021), _e4036, _e4048), _e171, _e4052), select(select(select(_e4007, _e3989, _e4021), _e4037, _e4048), _e182, _e4052));
phi_6383_ = select(1f, 0f, _e4052);
} else {
phi_6382_ = vec3<f32>(_e160, _e171, _e182);
phi_6383_ = 1f;
}
let _e4059 = phi_6382_;
let _e4061 = phi_6383_;
let _e4064 = (_e3963.member * _e4061);
global_5.member[_e117] = (_e128 * (_e3963.member_2.x * _e4064));
global_5.member[_e129] = (_e138 * (_e3963.member_2.y * _e4064));
global_5.member[_e140] = (_e149 * (_e3963.member_2.z * _e4064));
global_5.member[_e151] = _e4059.x;
global_5.member[_e162] = _e4059.y;
global_5.member[_e173] = _e4059.z;
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
