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
var phi_945_: u32;
var phi_3328_: type_29;
var phi_4030_: type_30;
var phi_4919_: type_5;
var phi_6029_: type_31;
var phi_6181_: vec3<f32>;
var phi_6182_: f32;
let _e87 = global;
let _e90 = arrayLength((&global_2.member));
let _e94 = arrayLength((&global_4.member));
let _e96 = arrayLength((&global_6.member));
let _e101 = global_1.member.member_2;
let _e104 = global_1.member.member;
let _e112 = (_e87.x + _e101.member);
let _e114 = (_e87.y + _e101.member_1);
if (_e112 < _e101.member_2) {
if (_e114 < _e101.member_3) {
let _e117 = (_e104.member * _e104.member_1);
let _e119 = ((_e114 * _e104.member) + _e112);
let _e120 = bitcast<i32>(_e119);
let _e122 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e124 = select(_e122, _e120, (_e120 < _e122));
let _e130 = global_5.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e131 = (_e117 + _e119);
let _e132 = bitcast<i32>(_e131);
let _e134 = select(_e122, _e132, (_e132 < _e122));
let _e140 = global_5.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
let _e142 = ((2u * _e117) + _e119);
let _e143 = bitcast<i32>(_e142);
let _e145 = select(_e122, _e143, (_e143 < _e122));
let _e151 = global_5.member[bitcast<u32>(select(0i, _e145, (_e145 > 0i)))];
let _e153 = ((3u * _e117) + _e119);
let _e154 = bitcast<i32>(_e153);
let _e156 = select(_e122, _e154, (_e154 < _e122));
let _e162 = global_5.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e164 = ((4u * _e117) + _e119);
let _e165 = bitcast<i32>(_e164);
let _e167 = select(_e122, _e165, (_e165 < _e122));
let _e173 = global_5.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e175 = ((5u * _e117) + _e119);
let _e176 = bitcast<i32>(_e175);
let _e178 = select(_e122, _e176, (_e176 < _e122));
let _e184 = global_5.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((6u * _e117) + _e119);
let _e187 = bitcast<i32>(_e186);
let _e189 = select(_e122, _e187, (_e187 < _e122));
let _e195 = global_5.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = ((7u * _e117) + _e119);
let _e198 = bitcast<i32>(_e197);
let _e200 = select(_e122, _e198, (_e198 < _e122));
let _e206 = global_5.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((8u * _e117) + _e119);
let _e209 = bitcast<i32>(_e208);
let _e211 = select(_e122, _e209, (_e209 < _e122));
let _e217 = global_5.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e221 = global_1.member.member_8.member;
let _e225 = global_1.member.member_8.member_1;
let _e226 = (_e221 * _e225);
if (_e96 >= (_e226 * 2u)) {
let _e230 = bitcast<i32>((_e114 * _e221));
let _e232 = bitcast<i32>(_e112);
let _e237 = global_6.member[bitcast<u32>((_e230 + _e232))];
let _e243 = global_6.member[bitcast<u32>(((bitcast<i32>(_e226) + _e230) + _e232))];
let _e244 = f32(_e232);
let _e246 = f32(bitcast<i32>(_e114));
let _e252 = global_1.member.member_5.member;
let _e256 = global_1.member.member_8.member_8;
let _e257 = (_e252 - _e256);
let _e261 = global_1.member.member_8.member_2;
let _e265 = global_1.member.member_8.member_6;
let _e272 = global_1.member.member_8.member_4;
let _e274 = ((_e261 + (_e265 * _e257)) + (((_e244 - _e237) + 0.5f) * _e272));
let _e278 = global_1.member.member_8.member_3;
let _e282 = global_1.member.member_8.member_7;
let _e287 = ((_e278 + (_e282 * _e257)) + (((_e246 - _e243) + 0.5f) * _e272));
let _e291 = global_1.member.member_5.member_1;
let _e292 = (_e291 - _e256);
let _e297 = ((_e261 + (_e265 * _e292)) + ((_e244 + 0.5f) * _e272));
let _e302 = ((_e278 + (_e282 * _e292)) + ((_e246 + 0.5f) * _e272));
let _e306 = global_1.member.member_6.member;
let _e317 = ((((_e306.member.member * _e274) + (_e306.member.member_1 * _e287)) + (_e306.member.member_2 * _e252)) + _e306.member_1);
let _e321 = global_1.member.member_6.member_1;
let _e332 = ((((_e321.member.member * _e274) + (_e321.member.member_1 * _e287)) + (_e321.member.member_2 * _e252)) + _e321.member_1);
let _e336 = global_1.member.member_6.member_2;
let _e347 = ((((_e336.member.member * _e274) + (_e336.member.member_1 * _e287)) + (_e336.member.member_2 * _e252)) + _e336.member_1);
let _e353 = ((((_e306.member.member * _e297) + (_e306.member.member_1 * _e302)) + (_e306.member.member_2 * _e291)) + _e306.member_1);
let _e359 = ((((_e321.member.member * _e297) + (_e321.member.member_1 * _e302)) + (_e321.member.member_2 * _e291)) + _e321.member_1);
let _e365 = ((((_e336.member.member * _e297) + (_e336.member.member_1 * _e302)) + (_e336.member.member_2 * _e291)) + _e336.member_1);
let _e371 = global_1.member.member_6.member_3.member;
let _e372 = (_e371 - 1f);
let _e381 = global_1.member.member_6.member_3.member_1;
let _e382 = (_e381 - 1f);
let _e391 = global_1.member.member_6.member_3.member_2;
let _e392 = (_e391 - 1f);
let _e411 = global_1.member.member_6.member_4;
let _e412 = (_e371 - 0.5f);
let _e414 = select(-0.5f, _e353, (_e353 > -0.5f));
let _e416 = select(_e412, _e414, (_e414 < _e412));
let _e417 = (_e381 - 0.5f);
let _e419 = select(-0.5f, _e359, (_e359 > -0.5f));
let _e421 = select(_e417, _e419, (_e419 < _e417));
let _e422 = (_e391 - 0.5f);
let _e424 = select(-0.5f, _e365, (_e365 > -0.5f));
let _e426 = select(_e422, _e424, (_e424 < _e422));
let _e432 = bitcast<f32>((bitcast<u32>((_e353 - _e317)) & 2147483647u));
let _e435 = bitcast<f32>((bitcast<u32>((_e359 - _e332)) & 2147483647u));
let _e437 = select(_e435, _e432, (_e432 > _e435));
let _e440 = bitcast<f32>((bitcast<u32>((_e365 - _e347)) & 2147483647u));
let _e449 = bitcast<f32>((bitcast<u32>((_e353 - _e416)) & 2147483647u));
let _e452 = bitcast<f32>((bitcast<u32>((_e359 - _e421)) & 2147483647u));
let _e454 = select(_e452, _e449, (_e449 > _e452));
let _e457 = bitcast<f32>((bitcast<u32>((_e365 - _e426)) & 2147483647u));
let _e461 = (_e416 + 0.5f);
let _e463 = select(0f, _e461, (_e461 > 0f));
let _e465 = select(_e372, _e463, (_e463 < _e372));
let _e472 = select(0i, select(select(i32(_e465), i32(-2147483648), (_e465 < -2147483600f)), 2147483647i, (_e465 > 2147483500f)), (_e465 == _e465));
let _e480 = global_1.member.member_6.member_12;
let _e481 = (_e480 & 31u);
let _e484 = (_e421 + 0.5f);
let _e486 = select(0f, _e484, (_e484 > 0f));
let _e488 = select(_e382, _e486, (_e486 < _e382));
let _e495 = select(0i, select(select(i32(_e488), i32(-2147483648), (_e488 < -2147483600f)), 2147483647i, (_e488 > 2147483500f)), (_e488 == _e488));
let _e502 = (_e426 + 0.5f);
let _e504 = select(0f, _e502, (_e502 > 0f));
let _e506 = select(_e392, _e504, (_e504 < _e392));
let _e513 = select(0i, select(select(i32(_e506), i32(-2147483648), (_e506 < -2147483600f)), 2147483647i, (_e506 > 2147483500f)), (_e506 == _e506));
let _e524 = global_1.member.member_6.member_9.member;
let _e530 = global_1.member.member_6.member_9.member_1;
let _e535 = global_1.member.member_6.member_10;
let _e541 = ((bitcast<i32>(_e535) + ((_e472 - select(0i, 1i, (_e465 < f32(_e472)))) >> bitcast<u32>(_e481))) + (bitcast<i32>(_e524) * (((_e495 - select(0i, 1i, (_e488 < f32(_e495)))) >> bitcast<u32>(_e481)) + (bitcast<i32>(_e530) * ((_e513 - select(0i, 1i, (_e506 < f32(_e513)))) >> bitcast<u32>(_e481))))));
let _e543 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e545 = select(_e543, _e541, (_e541 < _e543));
let _e551 = global_3.member[bitcast<u32>(select(0i, _e545, (_e545 > 0i)))];
let _e557 = global_1.member.member_1;
phi_945_ = select(select(7u, 3u, (((((((_e317 >= 0f) && (_e317 <= _e372)) && (_e332 >= 0f)) && (_e332 <= _e382)) && (_e347 >= 0f)) && (_e347 <= _e392)) && ((((((_e353 >= 0f) && (_e353 <= _e372)) && (_e359 >= 0f)) && (_e359 <= _e382)) && (_e365 >= 0f)) && (_e365 <= _e392)))), 1u, (((_e557 & 64u) != 0u) || ((((select(_e440, _e437, (_e437 > _e440)) <= _e411) && ((select(_e457, _e454, (_e454 > _e457)) > _e411) || (_e551 != 0u))) && true) && ((_e557 & 32u) != 0u))));
} else {
phi_945_ = 7u;
}
let _e567 = phi_945_;
if (_e567 > 1u) {
let _e573 = bitcast<i32>(((_e114 * _e221) + _e112));
let _e576 = (bitcast<i32>(_e96) - 1i);
let _e578 = select(_e576, _e573, (_e573 < _e576));
let _e584 = global_6.member[bitcast<u32>(select(0i, _e578, (_e578 > 0i)))];
let _e585 = (bitcast<i32>(_e226) + _e573);
let _e587 = select(_e576, _e585, (_e585 < _e576));
let _e593 = global_6.member[bitcast<u32>(select(0i, _e587, (_e587 > 0i)))];
let _e595 = f32(bitcast<i32>(_e112));
let _e597 = f32(bitcast<i32>(_e114));
let _e603 = global_1.member.member_5.member;
let _e607 = global_1.member.member_8.member_8;
let _e608 = (_e603 - _e607);
let _e612 = global_1.member.member_8.member_2;
let _e616 = global_1.member.member_8.member_6;
let _e623 = global_1.member.member_8.member_4;
let _e625 = ((_e612 + (_e616 * _e608)) + (((_e595 - _e584) + 0.5f) * _e623));
let _e629 = global_1.member.member_8.member_3;
let _e633 = global_1.member.member_8.member_7;
let _e638 = ((_e629 + (_e633 * _e608)) + (((_e597 - _e593) + 0.5f) * _e623));
let _e642 = global_1.member.member_5.member_1;
let _e643 = (_e642 - _e607);
let _e648 = ((_e612 + (_e616 * _e643)) + ((_e595 + 0.5f) * _e623));
let _e653 = ((_e629 + (_e633 * _e643)) + ((_e597 + 0.5f) * _e623));
let _e657 = global_1.member.member_6.member;
let _e668 = ((((_e657.member.member * _e625) + (_e657.member.member_1 * _e638)) + (_e657.member.member_2 * _e603)) + _e657.member_1);
let _e672 = global_1.member.member_6.member_1;
let _e683 = ((((_e672.member.member * _e625) + (_e672.member.member_1 * _e638)) + (_e672.member.member_2 * _e603)) + _e672.member_1);
let _e687 = global_1.member.member_6.member_2;
let _e698 = ((((_e687.member.member * _e625) + (_e687.member.member_1 * _e638)) + (_e687.member.member_2 * _e603)) + _e687.member_1);
let _e704 = ((((_e657.member.member * _e648) + (_e657.member.member_1 * _e653)) + (_e657.member.member_2 * _e642)) + _e657.member_1);
let _e710 = ((((_e672.member.member * _e648) + (_e672.member.member_1 * _e653)) + (_e672.member.member_2 * _e642)) + _e672.member_1);
let _e716 = ((((_e687.member.member * _e648) + (_e687.member.member_1 * _e653)) + (_e687.member.member_2 * _e642)) + _e687.member_1);
let _e718 = (_e104.member_2 == 2u);
let _e721 = (((_e104.member_2 == 1u) || _e718) || (_e104.member_2 == 5u));
if _e721 {
let _e726 = global_1.member.member_6.member_3.member;
let _e727 = (_e726 - 0.5f);
let _e729 = select(-0.5f, _e704, (_e704 > -0.5f));
let _e731 = select(_e727, _e729, (_e729 < _e727));
let _e736 = global_1.member.member_6.member_3.member_1;
let _e737 = (_e736 - 0.5f);
let _e739 = select(-0.5f, _e710, (_e710 > -0.5f));
let _e741 = select(_e737, _e739, (_e739 < _e737));
let _e746 = global_1.member.member_6.member_3.member_2;
let _e747 = (_e746 - 0.5f);
let _e749 = select(-0.5f, _e716, (_e716 > -0.5f));
let _e751 = select(_e747, _e749, (_e749 < _e747));
let _e753 = select(-1f, _e731, (_e731 > -1f));
let _e755 = select(_e726, _e753, (_e753 < _e726));
let _e762 = select(0i, select(select(i32(_e755), i32(-2147483648), (_e755 < -2147483600f)), 2147483647i, (_e755 > 2147483500f)), (_e755 == _e755));
let _e766 = (_e762 - select(0i, 1i, (_e755 < f32(_e762))));
let _e768 = select(-1f, _e741, (_e741 > -1f));
let _e770 = select(_e736, _e768, (_e768 < _e736));
let _e777 = select(0i, select(select(i32(_e770), i32(-2147483648), (_e770 < -2147483600f)), 2147483647i, (_e770 > 2147483500f)), (_e770 == _e770));
let _e781 = (_e777 - select(0i, 1i, (_e770 < f32(_e777))));
let _e783 = select(-1f, _e751, (_e751 > -1f));
let _e785 = select(_e746, _e783, (_e783 < _e746));
let _e792 = select(0i, select(select(i32(_e785), i32(-2147483648), (_e785 < -2147483600f)), 2147483647i, (_e785 > 2147483500f)), (_e785 == _e785));
let _e796 = (_e792 - select(0i, 1i, (_e785 < f32(_e792))));
let _e800 = global_1.member.member_6.member_7;
let _e804 = global_1.member.member_6.member_8;
let _e805 = (_e766 + 1i);
let _e806 = (_e781 + 1i);
let _e807 = (_e796 + 1i);
let _e812 = global_1.member.member_6.member_11.member;
let _e818 = global_1.member.member_6.member_11.member_1;
let _e829 = ((_e805 >> bitcast<u32>(4i)) + (bitcast<i32>(_e812) * ((_e806 >> bitcast<u32>(4i)) + (bitcast<i32>(_e818) * (_e807 >> bitcast<u32>(4i))))));
let _e831 = (bitcast<i32>(_e90) - 1i);
let _e833 = select(_e831, _e829, (_e829 < _e831));
let _e839 = global_2.member[bitcast<u32>(select(0i, _e833, (_e833 > 0i)))];
let _e841 = (_e805 & 15i);
let _e844 = ((_e806 & 15i) * _e800);
let _e846 = (bitcast<i32>(_e839) + ((_e807 & 15i) * _e804));
let _e847 = (_e844 + _e800);
let _e849 = (_e844 + (2i * _e800));
let _e851 = (_e844 + (3i * _e800));
let _e852 = (_e846 + _e804);
let _e854 = (_e846 + (2i * _e804));
let _e856 = (_e846 + (3i * _e804));
local_4 = type_28(array<i32, 4>(_e841, _e841, _e841, _e841), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_5 = vec3<f32>((_e731 - f32(_e766)), (_e741 - f32(_e781)), (_e751 - f32(_e796)));
let _e870 = local_4.member[0u];
let _e871 = ((_e852 + _e847) + _e870);
let _e873 = (_e871 >> bitcast<u32>(2i));
let _e876 = bitcast<u32>(((_e871 & 3i) * 8i));
let _e878 = select(_e831, _e873, (_e873 < _e831));
let _e883 = global_2.member[bitcast<u32>(select(0i, _e878, (_e878 > 0i)))];
let _e887 = (_e873 + 1i);
let _e889 = select(_e831, _e887, (_e887 < _e831));
let _e894 = global_2.member[bitcast<u32>(select(0i, _e889, (_e889 > 0i)))];
let _e901 = ((_e883 >> bitcast<u32>((_e876 & 31u))) | ((_e894 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e876) & 31u))));
let _e904 = local_4.member_1[0u];
let _e910 = f32(bitcast<i32>(((_e901 >> bitcast<u32>((_e904 & 31u))) & 255u)));
let _e913 = local_4.member_1[1u];
let _e919 = f32(bitcast<i32>(((_e901 >> bitcast<u32>((_e913 & 31u))) & 255u)));
let _e922 = local_4.member_1[2u];
let _e928 = f32(bitcast<i32>(((_e901 >> bitcast<u32>((_e922 & 31u))) & 255u)));
let _e931 = local_4.member_1[3u];
let _e938 = local_5[0u];
let _e941 = (_e910 + ((_e919 - _e910) * _e938));
let _e942 = local_5[0u];
let _e945 = (_e919 + ((_e928 - _e919) * _e942));
let _e946 = local_5[0u];
let _e949 = (_e928 + ((f32(bitcast<i32>(((_e901 >> bitcast<u32>((_e931 & 31u))) & 255u))) - _e928) * _e946));
let _e951 = local_4.member[0u];
let _e952 = ((_e852 + _e849) + _e951);
let _e954 = (_e952 >> bitcast<u32>(2i));
let _e957 = bitcast<u32>(((_e952 & 3i) * 8i));
let _e959 = select(_e831, _e954, (_e954 < _e831));
let _e964 = global_2.member[bitcast<u32>(select(0i, _e959, (_e959 > 0i)))];
let _e968 = (_e954 + 1i);
let _e970 = select(_e831, _e968, (_e968 < _e831));
let _e975 = global_2.member[bitcast<u32>(select(0i, _e970, (_e970 > 0i)))];
let _e982 = ((_e964 >> bitcast<u32>((_e957 & 31u))) | ((_e975 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e957) & 31u))));
let _e983 = local_4.member_1[0u];
let _e989 = f32(bitcast<i32>(((_e982 >> bitcast<u32>((_e983 & 31u))) & 255u)));
let _e990 = local_4.member_1[1u];
let _e996 = f32(bitcast<i32>(((_e982 >> bitcast<u32>((_e990 & 31u))) & 255u)));
let _e997 = local_4.member_1[2u];
let _e1003 = f32(bitcast<i32>(((_e982 >> bitcast<u32>((_e997 & 31u))) & 255u)));
let _e1004 = local_4.member_1[3u];
let _e1011 = local_5[0u];
let _e1015 = local_5[0u];
let _e1018 = (_e996 + ((_e1003 - _e996) * _e1015));
let _e1019 = local_5[0u];
let _e1024 = local_4.member[0u];
let _e1025 = ((_e854 + _e847) + _e1024);
let _e1027 = (_e1025 >> bitcast<u32>(2i));
let _e1030 = bitcast<u32>(((_e1025 & 3i) * 8i));
let _e1032 = select(_e831, _e1027, (_e1027 < _e831));
let _e1037 = global_2.member[bitcast<u32>(select(0i, _e1032, (_e1032 > 0i)))];
let _e1041 = (_e1027 + 1i);
let _e1043 = select(_e831, _e1041, (_e1041 < _e831));
let _e1048 = global_2.member[bitcast<u32>(select(0i, _e1043, (_e1043 > 0i)))];
let _e1055 = ((_e1037 >> bitcast<u32>((_e1030 & 31u))) | ((_e1048 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1030) & 31u))));
let _e1056 = local_4.member_1[0u];
let _e1062 = f32(bitcast<i32>(((_e1055 >> bitcast<u32>((_e1056 & 31u))) & 255u)));
let _e1063 = local_4.member_1[1u];
let _e1069 = f32(bitcast<i32>(((_e1055 >> bitcast<u32>((_e1063 & 31u))) & 255u)));
let _e1070 = local_4.member_1[2u];
let _e1076 = f32(bitcast<i32>(((_e1055 >> bitcast<u32>((_e1070 & 31u))) & 255u)));
let _e1077 = local_4.member_1[3u];
let _e1084 = local_5[0u];
let _e1087 = (_e1062 + ((_e1069 - _e1062) * _e1084));
let _e1088 = local_5[0u];
let _e1091 = (_e1069 + ((_e1076 - _e1069) * _e1088));
let _e1092 = local_5[0u];
let _e1095 = (_e1076 + ((f32(bitcast<i32>(((_e1055 >> bitcast<u32>((_e1077 & 31u))) & 255u))) - _e1076) * _e1092));
let _e1097 = local_4.member[0u];
let _e1098 = ((_e854 + _e849) + _e1097);
let _e1100 = (_e1098 >> bitcast<u32>(2i));
let _e1103 = bitcast<u32>(((_e1098 & 3i) * 8i));
let _e1105 = select(_e831, _e1100, (_e1100 < _e831));
let _e1110 = global_2.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
let _e1114 = (_e1100 + 1i);
let _e1116 = select(_e831, _e1114, (_e1114 < _e831));
let _e1121 = global_2.member[bitcast<u32>(select(0i, _e1116, (_e1116 > 0i)))];
let _e1128 = ((_e1110 >> bitcast<u32>((_e1103 & 31u))) | ((_e1121 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1103) & 31u))));
let _e1129 = local_4.member_1[0u];
let _e1135 = f32(bitcast<i32>(((_e1128 >> bitcast<u32>((_e1129 & 31u))) & 255u)));
let _e1136 = local_4.member_1[1u];
let _e1142 = f32(bitcast<i32>(((_e1128 >> bitcast<u32>((_e1136 & 31u))) & 255u)));
let _e1143 = local_4.member_1[2u];
let _e1149 = f32(bitcast<i32>(((_e1128 >> bitcast<u32>((_e1143 & 31u))) & 255u)));
let _e1150 = local_4.member_1[3u];
let _e1157 = local_5[0u];
let _e1161 = local_5[0u];
let _e1164 = (_e1142 + ((_e1149 - _e1142) * _e1161));
let _e1165 = local_5[0u];
let _e1170 = local_4.member[0u];
let _e1171 = ((_e852 + _e844) + _e1170);
let _e1173 = (_e1171 >> bitcast<u32>(2i));
let _e1176 = bitcast<u32>(((_e1171 & 3i) * 8i));
let _e1178 = select(_e831, _e1173, (_e1173 < _e831));
let _e1183 = global_2.member[bitcast<u32>(select(0i, _e1178, (_e1178 > 0i)))];
let _e1187 = (_e1173 + 1i);
let _e1189 = select(_e831, _e1187, (_e1187 < _e831));
let _e1194 = global_2.member[bitcast<u32>(select(0i, _e1189, (_e1189 > 0i)))];
let _e1201 = ((_e1183 >> bitcast<u32>((_e1176 & 31u))) | ((_e1194 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1176) & 31u))));
let _e1202 = local_4.member_1[1u];
let _e1208 = f32(bitcast<i32>(((_e1201 >> bitcast<u32>((_e1202 & 31u))) & 255u)));
let _e1209 = local_4.member_1[2u];
let _e1216 = local_5[0u];
let _e1219 = (_e1208 + ((f32(bitcast<i32>(((_e1201 >> bitcast<u32>((_e1209 & 31u))) & 255u))) - _e1208) * _e1216));
let _e1221 = local_4.member[0u];
let _e1222 = ((_e852 + _e851) + _e1221);
let _e1224 = (_e1222 >> bitcast<u32>(2i));
let _e1227 = bitcast<u32>(((_e1222 & 3i) * 8i));
let _e1229 = select(_e831, _e1224, (_e1224 < _e831));
let _e1234 = global_2.member[bitcast<u32>(select(0i, _e1229, (_e1229 > 0i)))];
let _e1238 = (_e1224 + 1i);
let _e1240 = select(_e831, _e1238, (_e1238 < _e831));
let _e1245 = global_2.member[bitcast<u32>(select(0i, _e1240, (_e1240 > 0i)))];
let _e1252 = ((_e1234 >> bitcast<u32>((_e1227 & 31u))) | ((_e1245 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1227) & 31u))));
let _e1253 = local_4.member_1[1u];
let _e1259 = f32(bitcast<i32>(((_e1252 >> bitcast<u32>((_e1253 & 31u))) & 255u)));
let _e1260 = local_4.member_1[2u];
let _e1267 = local_5[0u];
let _e1272 = local_4.member[0u];
let _e1273 = ((_e854 + _e844) + _e1272);
let _e1275 = (_e1273 >> bitcast<u32>(2i));
let _e1278 = bitcast<u32>(((_e1273 & 3i) * 8i));
let _e1280 = select(_e831, _e1275, (_e1275 < _e831));
let _e1285 = global_2.member[bitcast<u32>(select(0i, _e1280, (_e1280 > 0i)))];
let _e1289 = (_e1275 + 1i);
let _e1291 = select(_e831, _e1289, (_e1289 < _e831));
let _e1296 = global_2.member[bitcast<u32>(select(0i, _e1291, (_e1291 > 0i)))];
let _e1303 = ((_e1285 >> bitcast<u32>((_e1278 & 31u))) | ((_e1296 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1278) & 31u))));
let _e1304 = local_4.member_1[1u];
let _e1310 = f32(bitcast<i32>(((_e1303 >> bitcast<u32>((_e1304 & 31u))) & 255u)));
let _e1311 = local_4.member_1[2u];
let _e1318 = local_5[0u];
let _e1321 = (_e1310 + ((f32(bitcast<i32>(((_e1303 >> bitcast<u32>((_e1311 & 31u))) & 255u))) - _e1310) * _e1318));
let _e1323 = local_4.member[0u];
let _e1324 = ((_e854 + _e851) + _e1323);
let _e1326 = (_e1324 >> bitcast<u32>(2i));
let _e1329 = bitcast<u32>(((_e1324 & 3i) * 8i));
let _e1331 = select(_e831, _e1326, (_e1326 < _e831));
let _e1336 = global_2.member[bitcast<u32>(select(0i, _e1331, (_e1331 > 0i)))];
let _e1340 = (_e1326 + 1i);
let _e1342 = select(_e831, _e1340, (_e1340 < _e831));
let _e1347 = global_2.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1354 = ((_e1336 >> bitcast<u32>((_e1329 & 31u))) | ((_e1347 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1329) & 31u))));
let _e1355 = local_4.member_1[1u];
let _e1361 = f32(bitcast<i32>(((_e1354 >> bitcast<u32>((_e1355 & 31u))) & 255u)));
let _e1362 = local_4.member_1[2u];
let _e1369 = local_5[0u];
let _e1374 = local_4.member[0u];
let _e1375 = ((_e846 + _e847) + _e1374);
let _e1377 = (_e1375 >> bitcast<u32>(2i));
let _e1380 = bitcast<u32>(((_e1375 & 3i) * 8i));
let _e1382 = select(_e831, _e1377, (_e1377 < _e831));
let _e1387 = global_2.member[bitcast<u32>(select(0i, _e1382, (_e1382 > 0i)))];
let _e1391 = (_e1377 + 1i);
let _e1393 = select(_e831, _e1391, (_e1391 < _e831));
let _e1398 = global_2.member[bitcast<u32>(select(0i, _e1393, (_e1393 > 0i)))];
let _e1405 = ((_e1387 >> bitcast<u32>((_e1380 & 31u))) | ((_e1398 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1380) & 31u))));
let _e1406 = local_4.member_1[1u];
let _e1412 = f32(bitcast<i32>(((_e1405 >> bitcast<u32>((_e1406 & 31u))) & 255u)));
let _e1413 = local_4.member_1[2u];
let _e1420 = local_5[0u];
let _e1423 = (_e1412 + ((f32(bitcast<i32>(((_e1405 >> bitcast<u32>((_e1413 & 31u))) & 255u))) - _e1412) * _e1420));
let _e1425 = local_4.member[0u];
let _e1426 = ((_e856 + _e847) + _e1425);
let _e1428 = (_e1426 >> bitcast<u32>(2i));
let _e1431 = bitcast<u32>(((_e1426 & 3i) * 8i));
let _e1433 = select(_e831, _e1428, (_e1428 < _e831));
let _e1438 = global_2.member[bitcast<u32>(select(0i, _e1433, (_e1433 > 0i)))];
let _e1442 = (_e1428 + 1i);
let _e1444 = select(_e831, _e1442, (_e1442 < _e831));
let _e1449 = global_2.member[bitcast<u32>(select(0i, _e1444, (_e1444 > 0i)))];
let _e1456 = ((_e1438 >> bitcast<u32>((_e1431 & 31u))) | ((_e1449 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1431) & 31u))));
let _e1457 = local_4.member_1[1u];
let _e1463 = f32(bitcast<i32>(((_e1456 >> bitcast<u32>((_e1457 & 31u))) & 255u)));
let _e1464 = local_4.member_1[2u];
let _e1471 = local_5[0u];
let _e1474 = (_e1463 + ((f32(bitcast<i32>(((_e1456 >> bitcast<u32>((_e1464 & 31u))) & 255u))) - _e1463) * _e1471));
let _e1476 = local_4.member[0u];
let _e1477 = ((_e846 + _e849) + _e1476);
let _e1479 = (_e1477 >> bitcast<u32>(2i));
let _e1482 = bitcast<u32>(((_e1477 & 3i) * 8i));
let _e1484 = select(_e831, _e1479, (_e1479 < _e831));
let _e1489 = global_2.member[bitcast<u32>(select(0i, _e1484, (_e1484 > 0i)))];
let _e1493 = (_e1479 + 1i);
let _e1495 = select(_e831, _e1493, (_e1493 < _e831));
let _e1500 = global_2.member[bitcast<u32>(select(0i, _e1495, (_e1495 > 0i)))];
let _e1507 = ((_e1489 >> bitcast<u32>((_e1482 & 31u))) | ((_e1500 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1482) & 31u))));
let _e1508 = local_4.member_1[1u];
let _e1514 = f32(bitcast<i32>(((_e1507 >> bitcast<u32>((_e1508 & 31u))) & 255u)));
let _e1515 = local_4.member_1[2u];
let _e1522 = local_5[0u];
let _e1527 = local_4.member[0u];
let _e1528 = ((_e856 + _e849) + _e1527);
let _e1530 = (_e1528 >> bitcast<u32>(2i));
let _e1533 = bitcast<u32>(((_e1528 & 3i) * 8i));
let _e1535 = select(_e831, _e1530, (_e1530 < _e831));
let _e1540 = global_2.member[bitcast<u32>(select(0i, _e1535, (_e1535 > 0i)))];
let _e1544 = (_e1530 + 1i);
let _e1546 = select(_e831, _e1544, (_e1544 < _e831));
let _e1551 = global_2.member[bitcast<u32>(select(0i, _e1546, (_e1546 > 0i)))];
let _e1558 = ((_e1540 >> bitcast<u32>((_e1533 & 31u))) | ((_e1551 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1533) & 31u))));
let _e1559 = local_4.member_1[1u];
let _e1565 = f32(bitcast<i32>(((_e1558 >> bitcast<u32>((_e1559 & 31u))) & 255u)));
let _e1566 = local_4.member_1[2u];
let _e1573 = local_5[0u];
let _e1578 = local_5[1u];
let _e1581 = (_e945 + ((_e1018 - _e945) * _e1578));
let _e1582 = local_5[1u];
let _e1585 = (_e1091 + ((_e1164 - _e1091) * _e1582));
let _e1586 = local_5[1u];
let _e1589 = (_e941 + (((_e989 + ((_e996 - _e989) * _e1011)) - _e941) * _e1586));
let _e1590 = local_5[1u];
let _e1595 = local_5[2u];
let _e1599 = local_5[1u];
let _e1602 = (_e949 + (((_e1003 + ((f32(bitcast<i32>(((_e982 >> bitcast<u32>((_e1004 & 31u))) & 255u))) - _e1003) * _e1019)) - _e949) * _e1599));
let _e1603 = local_5[1u];
let _e1607 = local_5[2u];
let _e1611 = local_5[1u];
let _e1614 = (_e1219 + ((_e945 - _e1219) * _e1611));
let _e1615 = local_5[1u];
let _e1619 = local_5[2u];
let _e1623 = local_5[1u];
let _e1626 = (_e1018 + (((_e1259 + ((f32(bitcast<i32>(((_e1252 >> bitcast<u32>((_e1260 & 31u))) & 255u))) - _e1259) * _e1267)) - _e1018) * _e1623));
let _e1627 = local_5[1u];
let _e1631 = local_5[2u];
let _e1635 = local_5[1u];
let _e1638 = (_e1423 + (((_e1514 + ((f32(bitcast<i32>(((_e1507 >> bitcast<u32>((_e1515 & 31u))) & 255u))) - _e1514) * _e1522)) - _e1423) * _e1635));
let _e1639 = local_5[2u];
let _e1643 = local_5[1u];
let _e1647 = local_5[2u];
let _e1651 = local_5[2u];
let _e1658 = global_1.member.member_6.member_5;
let _e1663 = global_1.member.member_6.member_6;
let _e1664 = (((_e1581 + ((_e1585 - _e1581) * _e1651)) * _e1658) + _e1663);
let _e1666 = select(0f, _e1664, (_e1664 > 0f));
let _e1668 = select(1f, _e1666, (_e1666 < 1f));
let _e1670 = (((_e1589 + (((_e1087 + (((_e1135 + ((_e1142 - _e1135) * _e1157)) - _e1087) * _e1590)) - _e1589) * _e1595)) * _e1658) + _e1663);
let _e1672 = select(0f, _e1670, (_e1670 > 0f));
let _e1674 = select(1f, _e1672, (_e1672 < 1f));
let _e1676 = (((_e1602 + (((_e1095 + (((_e1149 + ((f32(bitcast<i32>(((_e1128 >> bitcast<u32>((_e1150 & 31u))) & 255u))) - _e1149) * _e1165)) - _e1095) * _e1603)) - _e1602) * _e1607)) * _e1658) + _e1663);
let _e1678 = select(0f, _e1676, (_e1676 > 0f));
let _e1680 = select(1f, _e1678, (_e1678 < 1f));
let _e1682 = (((_e1614 + (((_e1321 + ((_e1091 - _e1321) * _e1615)) - _e1614) * _e1619)) * _e1658) + _e1663);
let _e1684 = select(0f, _e1682, (_e1682 > 0f));
let _e1686 = select(1f, _e1684, (_e1684 < 1f));
let _e1688 = (((_e1626 + (((_e1164 + (((_e1361 + ((f32(bitcast<i32>(((_e1354 >> bitcast<u32>((_e1362 & 31u))) & 255u))) - _e1361) * _e1369)) - _e1164) * _e1627)) - _e1626) * _e1631)) * _e1658) + _e1663);
let _e1690 = select(0f, _e1688, (_e1688 > 0f));
let _e1692 = select(1f, _e1690, (_e1690 < 1f));
let _e1694 = (((_e1638 + ((_e1581 - _e1638) * _e1639)) * _e1658) + _e1663);
let _e1696 = select(0f, _e1694, (_e1694 > 0f));
let _e1698 = select(1f, _e1696, (_e1696 < 1f));
let _e1700 = (((_e1585 + (((_e1474 + (((_e1565 + ((f32(bitcast<i32>(((_e1558 >> bitcast<u32>((_e1566 & 31u))) & 255u))) - _e1565) * _e1573)) - _e1474) * _e1643)) - _e1585) * _e1647)) * _e1658) + _e1663);
let _e1702 = select(0f, _e1700, (_e1700 > 0f));
let _e1704 = select(1f, _e1702, (_e1702 < 1f));
let _e1705 = (_e1668 * 1024f);
let _e1706 = (1024f - 1f);
let _e1708 = select(0f, _e1705, (_e1705 > 0f));
let _e1710 = select(_e1706, _e1708, (_e1708 < _e1706));
let _e1717 = select(0i, select(select(i32(_e1710), i32(-2147483648), (_e1710 < -2147483600f)), 2147483647i, (_e1710 > 2147483500f)), (_e1710 == _e1710));
let _e1721 = (_e1717 - select(0i, 1i, (_e1710 < f32(_e1717))));
let _e1722 = (262147i + _e1721);
let _e1724 = (bitcast<i32>(_e94) - 1i);
let _e1726 = select(_e1724, _e1722, (_e1722 < _e1724));
let _e1732 = global_4.member[bitcast<u32>(select(0i, _e1726, (_e1726 > 0i)))];
let _e1742 = select(_e1724, 262146i, (262146i < _e1724));
let _e1748 = global_4.member[bitcast<u32>(select(0i, _e1742, (_e1742 > 0i)))];
let _e1749 = bitcast<f32>(_e1748);
let _e1750 = (f32((bitcast<i32>((_e1732 & 4095u)) - 2048i)) * _e1749);
let _e1752 = select(_e1724, 262144i, (262144i < _e1724));
let _e1758 = global_4.member[bitcast<u32>(select(0i, _e1752, (_e1752 > 0i)))];
let _e1759 = bitcast<f32>(_e1758);
let _e1761 = select(_e1724, 262145i, (262145i < _e1724));
let _e1767 = global_4.member[bitcast<u32>(select(0i, _e1761, (_e1761 > 0i)))];
let _e1768 = bitcast<f32>(_e1767);
let _e1774 = ((_e1759 + (f32(bitcast<i32>((_e1732 >> bitcast<u32>(12u)))) * _e1768)) + (_e1750 * (_e1705 - f32(_e1721))));
let _e1775 = (_e1750 * 1024f);
if _e718 {
let _e1782 = ((0.5f * (_e1680 - _e1674)) * _e1775);
let _e1783 = ((0.5f * (_e1692 - _e1686)) * _e1775);
let _e1784 = ((0.5f * (_e1704 - _e1698)) * _e1775);
phi_3328_ = type_29(_e1774, vec3<f32>(_e1782, _e1783, _e1784), vec3<f32>((_e1782 * _e1774), (_e1783 * _e1774), (_e1784 * _e1774)));
} else {
let _e1791 = (_e1674 * 1024f);
let _e1793 = select(0f, _e1791, (_e1791 > 0f));
let _e1795 = select(_e1706, _e1793, (_e1793 < _e1706));
let _e1802 = select(0i, select(select(i32(_e1795), i32(-2147483648), (_e1795 < -2147483600f)), 2147483647i, (_e1795 > 2147483500f)), (_e1795 == _e1795));
let _e1806 = (_e1802 - select(0i, 1i, (_e1795 < f32(_e1802))));
let _e1807 = (262147i + _e1806);
let _e1809 = select(_e1724, _e1807, (_e1807 < _e1724));
let _e1815 = global_4.member[bitcast<u32>(select(0i, _e1809, (_e1809 > 0i)))];
let _e1830 = ((_e1759 + (f32(bitcast<i32>((_e1815 >> bitcast<u32>(12u)))) * _e1768)) + ((f32((bitcast<i32>((_e1815 & 4095u)) - 2048i)) * _e1749) * (_e1791 - f32(_e1806))));
let _e1831 = (_e1680 * 1024f);
let _e1833 = select(0f, _e1831, (_e1831 > 0f));
let _e1835 = select(_e1706, _e1833, (_e1833 < _e1706));
let _e1842 = select(0i, select(select(i32(_e1835), i32(-2147483648), (_e1835 < -2147483600f)), 2147483647i, (_e1835 > 2147483500f)), (_e1835 == _e1835));
let _e1846 = (_e1842 - select(0i, 1i, (_e1835 < f32(_e1842))));
let _e1847 = (262147i + _e1846);
let _e1849 = select(_e1724, _e1847, (_e1847 < _e1724));
let _e1855 = global_4.member[bitcast<u32>(select(0i, _e1849, (_e1849 > 0i)))];
let _e1870 = ((_e1759 + (f32(bitcast<i32>((_e1855 >> bitcast<u32>(12u)))) * _e1768)) + ((f32((bitcast<i32>((_e1855 & 4095u)) - 2048i)) * _e1749) * (_e1831 - f32(_e1846))));
let _e1871 = (_e1686 * 1024f);
let _e1873 = select(0f, _e1871, (_e1871 > 0f));
let _e1875 = select(_e1706, _e1873, (_e1873 < _e1706));
let _e1882 = select(0i, select(select(i32(_e1875), i32(-2147483648), (_e1875 < -2147483600f)), 2147483647i, (_e1875 > 2147483500f)), (_e1875 == _e1875));
let _e1886 = (_e1882 - select(0i, 1i, (_e1875 < f32(_e1882))));
let _e1887 = (262147i + _e1886);
let _e1889 = select(_e1724, _e1887, (_e1887 < _e1724));
let _e1895 = global_4.member[bitcast<u32>(select(0i, _e1889, (_e1889 > 0i)))];
let _e1910 = ((_e1759 + (f32(bitcast<i32>((_e1895 >> bitcast<u32>(12u)))) * _e1768)) + ((f32((bitcast<i32>((_e1895 & 4095u)) - 2048i)) * _e1749) * (_e1871 - f32(_e1886))));
let _e1911 = (_e1692 * 1024f);
let _e1913 = select(0f, _e1911, (_e1911 > 0f));
let _e1915 = select(_e1706, _e1913, (_e1913 < _e1706));
let _e1922 = select(0i, select(select(i32(_e1915), i32(-2147483648), (_e1915 < -2147483600f)), 2147483647i, (_e1915 > 2147483500f)), (_e1915 == _e1915));
let _e1926 = (_e1922 - select(0i, 1i, (_e1915 < f32(_e1922))));
let _e1927 = (262147i + _e1926);
let _e1929 = select(_e1724, _e1927, (_e1927 < _e1724));
let _e1935 = global_4.member[bitcast<u32>(select(0i, _e1929, (_e1929 > 0i)))];
let _e1950 = ((_e1759 + (f32(bitcast<i32>((_e1935 >> bitcast<u32>(12u)))) * _e1768)) + ((f32((bitcast<i32>((_e1935 & 4095u)) - 2048i)) * _e1749) * (_e1911 - f32(_e1926))));
let _e1951 = (_e1698 * 1024f);
let _e1953 = select(0f, _e1951, (_e1951 > 0f));
let _e1955 = select(_e1706, _e1953, (_e1953 < _e1706));
let _e1962 = select(0i, select(select(i32(_e1955), i32(-2147483648), (_e1955 < -2147483600f)), 2147483647i, (_e1955 > 2147483500f)), (_e1955 == _e1955));
let _e1966 = (_e1962 - select(0i, 1i, (_e1955 < f32(_e1962))));
let _e1967 = (262147i + _e1966);
let _e1969 = select(_e1724, _e1967, (_e1967 < _e1724));
let _e1975 = global_4.member[bitcast<u32>(select(0i, _e1969, (_e1969 > 0i)))];
let _e1990 = ((_e1759 + (f32(bitcast<i32>((_e1975 >> bitcast<u32>(12u)))) * _e1768)) + ((f32((bitcast<i32>((_e1975 & 4095u)) - 2048i)) * _e1749) * (_e1951 - f32(_e1966))));
let _e1991 = (_e1704 * 1024f);
let _e1993 = select(0f, _e1991, (_e1991 > 0f));
let _e1995 = select(_e1706, _e1993, (_e1993 < _e1706));
let _e2002 = select(0i, select(select(i32(_e1995), i32(-2147483648), (_e1995 < -2147483600f)), 2147483647i, (_e1995 > 2147483500f)), (_e1995 == _e1995));
let _e2006 = (_e2002 - select(0i, 1i, (_e1995 < f32(_e2002))));
let _e2007 = (262147i + _e2006);
let _e2009 = select(_e1724, _e2007, (_e2007 < _e1724));
let _e2015 = global_4.member[bitcast<u32>(select(0i, _e2009, (_e2009 > 0i)))];
let _e2030 = ((_e1759 + (f32(bitcast<i32>((_e2015 >> bitcast<u32>(12u)))) * _e1768)) + ((f32((bitcast<i32>((_e2015 & 4095u)) - 2048i)) * _e1749) * (_e1991 - f32(_e2006))));
let _e2031 = (_e1870 - _e1830);
let _e2033 = (_e1950 - _e1910);
let _e2035 = (_e2030 - _e1990);
phi_3328_ = type_29(_e1774, vec3<f32>((0.5f * _e2031), (0.5f * _e2033), (0.5f * _e2035)), vec3<f32>((0.25f * (_e2031 * (_e1870 + _e1830))), (0.25f * (_e2033 * (_e1950 + _e1910))), (0.25f * (_e2035 * (_e2030 + _e1990)))));
}
let _e2050 = phi_3328_;
let _e2065 = select(0f, 1f, ((((((_e704 >= -0.5f) && (_e704 <= _e727)) && (_e710 >= -0.5f)) && (_e710 <= _e737)) && (_e716 >= -0.5f)) && (_e716 <= _e747)));
let _e2067 = (0.5f * (_e1680 - _e1674));
let _e2069 = (0.5f * (_e1692 - _e1686));
let _e2071 = (0.5f * (_e1704 - _e1698));
let _e2077 = global_1.member.member_6.member.member.member;
let _e2083 = global_1.member.member_6.member.member.member_1;
let _e2089 = global_1.member.member_6.member.member.member_2;
let _e2095 = global_1.member.member_6.member_1.member.member;
let _e2101 = global_1.member.member_6.member_1.member.member_1;
let _e2107 = global_1.member.member_6.member_1.member.member_2;
let _e2113 = global_1.member.member_6.member_2.member.member;
let _e2119 = global_1.member.member_6.member_2.member.member_1;
let _e2125 = global_1.member.member_6.member_2.member.member_2;
phi_4030_ = type_30(_e1668, vec3<f32>(((((_e2077 * _e2067) + (_e2095 * _e2069)) + (_e2113 * _e2071)) * _e2065), ((((_e2083 * _e2067) + (_e2101 * _e2069)) + (_e2119 * _e2071)) * _e2065), ((((_e2089 * _e2067) + (_e2107 * _e2069)) + (_e2125 * _e2071)) * _e2065)), _e2050.member, vec3<f32>(((((_e2077 * _e2050.member_2.x) + (_e2095 * _e2050.member_2.y)) + (_e2113 * _e2050.member_2.z)) * _e2065), ((((_e2083 * _e2050.member_2.x) + (_e2101 * _e2050.member_2.y)) + (_e2119 * _e2050.member_2.z)) * _e2065), ((((_e2089 * _e2050.member_2.x) + (_e2107 * _e2050.member_2.y)) + (_e2125 * _e2050.member_2.z)) * _e2065)), vec3<f32>(((((_e2077 * _e2050.member_1.x) + (_e2095 * _e2050.member_1.y)) + (_e2113 * _e2050.member_1.z)) * _e2065), ((((_e2083 * _e2050.member_1.x) + (_e2101 * _e2050.member_1.y)) + (_e2119 * _e2050.member_1.z)) * _e2065), ((((_e2089 * _e2050.member_1.x) + (_e2107 * _e2050.member_1.y)) + (_e2125 * _e2050.member_1.z)) * _e2065)));
} else {
let _e2194 = global_1.member.member_6.member_3.member;
let _e2195 = (_e2194 - 0.5f);
let _e2197 = select(-0.5f, _e704, (_e704 > -0.5f));
let _e2199 = select(_e2195, _e2197, (_e2197 < _e2195));
let _e2204 = global_1.member.member_6.member_3.member_1;
let _e2205 = (_e2204 - 0.5f);
let _e2207 = select(-0.5f, _e710, (_e710 > -0.5f));
let _e2209 = select(_e2205, _e2207, (_e2207 < _e2205));
let _e2214 = global_1.member.member_6.member_3.member_2;
let _e2215 = (_e2214 - 0.5f);
let _e2217 = select(-0.5f, _e716, (_e716 > -0.5f));
let _e2219 = select(_e2215, _e2217, (_e2217 < _e2215));
let _e2221 = select(-1f, _e2199, (_e2199 > -1f));
let _e2223 = select(_e2194, _e2221, (_e2221 < _e2194));
let _e2230 = select(0i, select(select(i32(_e2223), i32(-2147483648), (_e2223 < -2147483600f)), 2147483647i, (_e2223 > 2147483500f)), (_e2223 == _e2223));
let _e2234 = (_e2230 - select(0i, 1i, (_e2223 < f32(_e2230))));
let _e2236 = select(-1f, _e2209, (_e2209 > -1f));
let _e2238 = select(_e2204, _e2236, (_e2236 < _e2204));
let _e2245 = select(0i, select(select(i32(_e2238), i32(-2147483648), (_e2238 < -2147483600f)), 2147483647i, (_e2238 > 2147483500f)), (_e2238 == _e2238));
let _e2249 = (_e2245 - select(0i, 1i, (_e2238 < f32(_e2245))));
let _e2251 = select(-1f, _e2219, (_e2219 > -1f));
let _e2253 = select(_e2214, _e2251, (_e2251 < _e2214));
let _e2260 = select(0i, select(select(i32(_e2253), i32(-2147483648), (_e2253 < -2147483600f)), 2147483647i, (_e2253 > 2147483500f)), (_e2253 == _e2253));
let _e2264 = (_e2260 - select(0i, 1i, (_e2253 < f32(_e2260))));
let _e2268 = global_1.member.member_6.member_7;
let _e2272 = global_1.member.member_6.member_8;
let _e2273 = (_e2234 + 1i);
let _e2274 = (_e2249 + 1i);
let _e2275 = (_e2264 + 1i);
let _e2280 = global_1.member.member_6.member_11.member;
let _e2286 = global_1.member.member_6.member_11.member_1;
let _e2297 = ((_e2273 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2280) * ((_e2274 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2286) * (_e2275 >> bitcast<u32>(4i))))));
let _e2299 = (bitcast<i32>(_e90) - 1i);
let _e2301 = select(_e2299, _e2297, (_e2297 < _e2299));
let _e2307 = global_2.member[bitcast<u32>(select(0i, _e2301, (_e2301 > 0i)))];
let _e2309 = (_e2273 & 15i);
let _e2312 = ((_e2274 & 15i) * _e2268);
let _e2314 = (bitcast<i32>(_e2307) + ((_e2275 & 15i) * _e2272));
let _e2315 = (_e2312 + _e2268);
let _e2317 = (_e2312 + (2i * _e2268));
let _e2318 = (_e2314 + _e2272);
let _e2320 = (_e2314 + (2i * _e2272));
local_2 = type_28(array<i32, 4>(_e2309, _e2309, _e2309, _e2309), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_3 = vec3<f32>((_e2199 - f32(_e2234)), (_e2209 - f32(_e2249)), (_e2219 - f32(_e2264)));
let _e2334 = local_2.member[0u];
let _e2335 = ((_e2318 + _e2315) + _e2334);
let _e2337 = (_e2335 >> bitcast<u32>(2i));
let _e2340 = bitcast<u32>(((_e2335 & 3i) * 8i));
let _e2342 = select(_e2299, _e2337, (_e2337 < _e2299));
let _e2347 = global_2.member[bitcast<u32>(select(0i, _e2342, (_e2342 > 0i)))];
let _e2351 = (_e2337 + 1i);
let _e2353 = select(_e2299, _e2351, (_e2351 < _e2299));
let _e2358 = global_2.member[bitcast<u32>(select(0i, _e2353, (_e2353 > 0i)))];
let _e2365 = ((_e2347 >> bitcast<u32>((_e2340 & 31u))) | ((_e2358 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2340) & 31u))));
let _e2368 = local_2.member_1[1u];
let _e2374 = f32(bitcast<i32>(((_e2365 >> bitcast<u32>((_e2368 & 31u))) & 255u)));
let _e2377 = local_2.member_1[2u];
let _e2384 = local_3[0u];
let _e2387 = (_e2374 + ((f32(bitcast<i32>(((_e2365 >> bitcast<u32>((_e2377 & 31u))) & 255u))) - _e2374) * _e2384));
let _e2389 = local_2.member[0u];
let _e2390 = ((_e2318 + _e2317) + _e2389);
let _e2392 = (_e2390 >> bitcast<u32>(2i));
let _e2395 = bitcast<u32>(((_e2390 & 3i) * 8i));
let _e2397 = select(_e2299, _e2392, (_e2392 < _e2299));
let _e2402 = global_2.member[bitcast<u32>(select(0i, _e2397, (_e2397 > 0i)))];
let _e2406 = (_e2392 + 1i);
let _e2408 = select(_e2299, _e2406, (_e2406 < _e2299));
let _e2413 = global_2.member[bitcast<u32>(select(0i, _e2408, (_e2408 > 0i)))];
let _e2420 = ((_e2402 >> bitcast<u32>((_e2395 & 31u))) | ((_e2413 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2395) & 31u))));
let _e2421 = local_2.member_1[1u];
let _e2427 = f32(bitcast<i32>(((_e2420 >> bitcast<u32>((_e2421 & 31u))) & 255u)));
let _e2428 = local_2.member_1[2u];
let _e2435 = local_3[0u];
let _e2440 = local_3[1u];
let _e2443 = (_e2387 + (((_e2427 + ((f32(bitcast<i32>(((_e2420 >> bitcast<u32>((_e2428 & 31u))) & 255u))) - _e2427) * _e2435)) - _e2387) * _e2440));
let _e2445 = local_2.member[0u];
let _e2446 = ((_e2320 + _e2315) + _e2445);
let _e2448 = (_e2446 >> bitcast<u32>(2i));
let _e2451 = bitcast<u32>(((_e2446 & 3i) * 8i));
let _e2453 = select(_e2299, _e2448, (_e2448 < _e2299));
let _e2458 = global_2.member[bitcast<u32>(select(0i, _e2453, (_e2453 > 0i)))];
let _e2462 = (_e2448 + 1i);
let _e2464 = select(_e2299, _e2462, (_e2462 < _e2299));
let _e2469 = global_2.member[bitcast<u32>(select(0i, _e2464, (_e2464 > 0i)))];
let _e2476 = ((_e2458 >> bitcast<u32>((_e2451 & 31u))) | ((_e2469 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2451) & 31u))));
let _e2477 = local_2.member_1[1u];
let _e2483 = f32(bitcast<i32>(((_e2476 >> bitcast<u32>((_e2477 & 31u))) & 255u)));
let _e2484 = local_2.member_1[2u];
let _e2491 = local_3[0u];
let _e2494 = (_e2483 + ((f32(bitcast<i32>(((_e2476 >> bitcast<u32>((_e2484 & 31u))) & 255u))) - _e2483) * _e2491));
let _e2496 = local_2.member[0u];
let _e2497 = ((_e2320 + _e2317) + _e2496);
let _e2499 = (_e2497 >> bitcast<u32>(2i));
let _e2502 = bitcast<u32>(((_e2497 & 3i) * 8i));
let _e2504 = select(_e2299, _e2499, (_e2499 < _e2299));
let _e2509 = global_2.member[bitcast<u32>(select(0i, _e2504, (_e2504 > 0i)))];
let _e2513 = (_e2499 + 1i);
let _e2515 = select(_e2299, _e2513, (_e2513 < _e2299));
let _e2520 = global_2.member[bitcast<u32>(select(0i, _e2515, (_e2515 > 0i)))];
let _e2527 = ((_e2509 >> bitcast<u32>((_e2502 & 31u))) | ((_e2520 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2502) & 31u))));
let _e2528 = local_2.member_1[1u];
let _e2534 = f32(bitcast<i32>(((_e2527 >> bitcast<u32>((_e2528 & 31u))) & 255u)));
let _e2535 = local_2.member_1[2u];
let _e2542 = local_3[0u];
let _e2546 = local_3[1u];
let _e2551 = local_3[2u];
let _e2558 = global_1.member.member_6.member_5;
let _e2563 = global_1.member.member_6.member_6;
let _e2564 = (((_e2443 + (((_e2494 + (((_e2534 + ((f32(bitcast<i32>(((_e2527 >> bitcast<u32>((_e2535 & 31u))) & 255u))) - _e2534) * _e2542)) - _e2494) * _e2546)) - _e2443) * _e2551)) * _e2558) + _e2563);
let _e2566 = select(0f, _e2564, (_e2564 > 0f));
phi_4030_ = type_30(select(1f, _e2566, (_e2566 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2571 = phi_4030_;
let _e2576 = global_1.member.member_6.member_3.member;
let _e2577 = (_e2576 - 0.5f);
let _e2579 = select(-0.5f, _e668, (_e668 > -0.5f));
let _e2581 = select(_e2577, _e2579, (_e2579 < _e2577));
let _e2586 = global_1.member.member_6.member_3.member_1;
let _e2587 = (_e2586 - 0.5f);
let _e2589 = select(-0.5f, _e683, (_e683 > -0.5f));
let _e2591 = select(_e2587, _e2589, (_e2589 < _e2587));
let _e2596 = global_1.member.member_6.member_3.member_2;
let _e2597 = (_e2596 - 0.5f);
let _e2599 = select(-0.5f, _e698, (_e698 > -0.5f));
let _e2601 = select(_e2597, _e2599, (_e2599 < _e2597));
let _e2603 = select(-1f, _e2581, (_e2581 > -1f));
let _e2605 = select(_e2576, _e2603, (_e2603 < _e2576));
let _e2612 = select(0i, select(select(i32(_e2605), i32(-2147483648), (_e2605 < -2147483600f)), 2147483647i, (_e2605 > 2147483500f)), (_e2605 == _e2605));
let _e2616 = (_e2612 - select(0i, 1i, (_e2605 < f32(_e2612))));
let _e2618 = select(-1f, _e2591, (_e2591 > -1f));
let _e2620 = select(_e2586, _e2618, (_e2618 < _e2586));
let _e2627 = select(0i, select(select(i32(_e2620), i32(-2147483648), (_e2620 < -2147483600f)), 2147483647i, (_e2620 > 2147483500f)), (_e2620 == _e2620));
let _e2631 = (_e2627 - select(0i, 1i, (_e2620 < f32(_e2627))));
let _e2633 = select(-1f, _e2601, (_e2601 > -1f));
let _e2635 = select(_e2596, _e2633, (_e2633 < _e2596));
let _e2642 = select(0i, select(select(i32(_e2635), i32(-2147483648), (_e2635 < -2147483600f)), 2147483647i, (_e2635 > 2147483500f)), (_e2635 == _e2635));
let _e2646 = (_e2642 - select(0i, 1i, (_e2635 < f32(_e2642))));
let _e2650 = global_1.member.member_6.member_7;
let _e2654 = global_1.member.member_6.member_8;
let _e2655 = (_e2616 + 1i);
let _e2656 = (_e2631 + 1i);
let _e2657 = (_e2646 + 1i);
let _e2662 = global_1.member.member_6.member_11.member;
let _e2668 = global_1.member.member_6.member_11.member_1;
let _e2679 = ((_e2655 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2662) * ((_e2656 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2668) * (_e2657 >> bitcast<u32>(4i))))));
let _e2681 = (bitcast<i32>(_e90) - 1i);
let _e2683 = select(_e2681, _e2679, (_e2679 < _e2681));
let _e2689 = global_2.member[bitcast<u32>(select(0i, _e2683, (_e2683 > 0i)))];
let _e2691 = (_e2655 & 15i);
let _e2694 = ((_e2656 & 15i) * _e2650);
let _e2696 = (bitcast<i32>(_e2689) + ((_e2657 & 15i) * _e2654));
let _e2697 = (_e2694 + _e2650);
let _e2699 = (_e2694 + (2i * _e2650));
let _e2700 = (_e2696 + _e2654);
let _e2702 = (_e2696 + (2i * _e2654));
local = type_28(array<i32, 4>(_e2691, _e2691, _e2691, _e2691), array<u32, 6>(0u, 8u, 16u, 24u, 0u, 0u));
local_1 = vec3<f32>((_e2581 - f32(_e2616)), (_e2591 - f32(_e2631)), (_e2601 - f32(_e2646)));
let _e2716 = local.member[0u];
let _e2717 = ((_e2700 + _e2697) + _e2716);
let _e2719 = (_e2717 >> bitcast<u32>(2i));
let _e2722 = bitcast<u32>(((_e2717 & 3i) * 8i));
let _e2724 = select(_e2681, _e2719, (_e2719 < _e2681));
let _e2729 = global_2.member[bitcast<u32>(select(0i, _e2724, (_e2724 > 0i)))];
let _e2733 = (_e2719 + 1i);
let _e2735 = select(_e2681, _e2733, (_e2733 < _e2681));
let _e2740 = global_2.member[bitcast<u32>(select(0i, _e2735, (_e2735 > 0i)))];
let _e2747 = ((_e2729 >> bitcast<u32>((_e2722 & 31u))) | ((_e2740 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2722) & 31u))));
let _e2750 = local.member_1[1u];
let _e2756 = f32(bitcast<i32>(((_e2747 >> bitcast<u32>((_e2750 & 31u))) & 255u)));
let _e2759 = local.member_1[2u];
let _e2766 = local_1[0u];
let _e2769 = (_e2756 + ((f32(bitcast<i32>(((_e2747 >> bitcast<u32>((_e2759 & 31u))) & 255u))) - _e2756) * _e2766));
let _e2771 = local.member[0u];
let _e2772 = ((_e2700 + _e2699) + _e2771);
let _e2774 = (_e2772 >> bitcast<u32>(2i));
let _e2777 = bitcast<u32>(((_e2772 & 3i) * 8i));
let _e2779 = select(_e2681, _e2774, (_e2774 < _e2681));
let _e2784 = global_2.member[bitcast<u32>(select(0i, _e2779, (_e2779 > 0i)))];
let _e2788 = (_e2774 + 1i);
let _e2790 = select(_e2681, _e2788, (_e2788 < _e2681));
let _e2795 = global_2.member[bitcast<u32>(select(0i, _e2790, (_e2790 > 0i)))];
let _e2802 = ((_e2784 >> bitcast<u32>((_e2777 & 31u))) | ((_e2795 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2777) & 31u))));
let _e2803 = local.member_1[1u];
let _e2809 = f32(bitcast<i32>(((_e2802 >> bitcast<u32>((_e2803 & 31u))) & 255u)));
let _e2810 = local.member_1[2u];
let _e2817 = local_1[0u];
let _e2822 = local_1[1u];
let _e2825 = (_e2769 + (((_e2809 + ((f32(bitcast<i32>(((_e2802 >> bitcast<u32>((_e2810 & 31u))) & 255u))) - _e2809) * _e2817)) - _e2769) * _e2822));
let _e2827 = local.member[0u];
let _e2828 = ((_e2702 + _e2697) + _e2827);
let _e2830 = (_e2828 >> bitcast<u32>(2i));
let _e2833 = bitcast<u32>(((_e2828 & 3i) * 8i));
let _e2835 = select(_e2681, _e2830, (_e2830 < _e2681));
let _e2840 = global_2.member[bitcast<u32>(select(0i, _e2835, (_e2835 > 0i)))];
let _e2844 = (_e2830 + 1i);
let _e2846 = select(_e2681, _e2844, (_e2844 < _e2681));
let _e2851 = global_2.member[bitcast<u32>(select(0i, _e2846, (_e2846 > 0i)))];
let _e2858 = ((_e2840 >> bitcast<u32>((_e2833 & 31u))) | ((_e2851 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2833) & 31u))));
let _e2859 = local.member_1[1u];
let _e2865 = f32(bitcast<i32>(((_e2858 >> bitcast<u32>((_e2859 & 31u))) & 255u)));
let _e2866 = local.member_1[2u];
let _e2873 = local_1[0u];
let _e2876 = (_e2865 + ((f32(bitcast<i32>(((_e2858 >> bitcast<u32>((_e2866 & 31u))) & 255u))) - _e2865) * _e2873));
let _e2878 = local.member[0u];
let _e2879 = ((_e2702 + _e2699) + _e2878);
let _e2881 = (_e2879 >> bitcast<u32>(2i));
let _e2884 = bitcast<u32>(((_e2879 & 3i) * 8i));
let _e2886 = select(_e2681, _e2881, (_e2881 < _e2681));
let _e2891 = global_2.member[bitcast<u32>(select(0i, _e2886, (_e2886 > 0i)))];
let _e2895 = (_e2881 + 1i);
let _e2897 = select(_e2681, _e2895, (_e2895 < _e2681));
let _e2902 = global_2.member[bitcast<u32>(select(0i, _e2897, (_e2897 > 0i)))];
let _e2909 = ((_e2891 >> bitcast<u32>((_e2884 & 31u))) | ((_e2902 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2884) & 31u))));
let _e2910 = local.member_1[1u];
let _e2916 = f32(bitcast<i32>(((_e2909 >> bitcast<u32>((_e2910 & 31u))) & 255u)));
let _e2917 = local.member_1[2u];
let _e2924 = local_1[0u];
let _e2928 = local_1[1u];
let _e2933 = local_1[2u];
let _e2940 = global_1.member.member_6.member_5;
let _e2945 = global_1.member.member_6.member_6;
let _e2946 = (((_e2825 + (((_e2876 + (((_e2916 + ((f32(bitcast<i32>(((_e2909 >> bitcast<u32>((_e2917 & 31u))) & 255u))) - _e2916) * _e2924)) - _e2876) * _e2928)) - _e2825) * _e2933)) * _e2940) + _e2945);
let _e2948 = select(0f, _e2946, (_e2946 > 0f));
let _e2950 = select(1f, _e2948, (_e2948 < 1f));
let _e2953 = global_1.member.member_1;
if ((_e2953 & 16u) == 0u) {
phi_4919_ = type_5(1f, 1f, 1f);
} else {
let _e2959 = global_1.member.member_14.member;
let _e2970 = ((((_e2959.member.member * _e625) + (_e2959.member.member_1 * _e638)) + (_e2959.member.member_2 * _e603)) + _e2959.member_1);
let _e2976 = ((((_e2959.member.member * _e648) + (_e2959.member.member_1 * _e653)) + (_e2959.member.member_2 * _e642)) + _e2959.member_1);
let _e2978 = select(_e2976, _e2970, (_e2970 < _e2976));
let _e2980 = select(_e2976, _e2970, (_e2970 > _e2976));
let _e2982 = (_e2980 - _e2978);
let _e2985 = (-(_e2978) / select(1e-30f, _e2982, (_e2982 > 1e-30f)));
let _e2987 = select(0f, _e2985, (_e2985 > 0f));
let _e2993 = select(select(select(1f, _e2987, (_e2987 < 1f)), 1f, (_e2980 <= 0f)), 0f, (_e2978 > 0f));
let _e2998 = global_1.member.member_14.member_1;
let _e2999 = (_e2998 != 0u);
let _e3009 = global_1.member.member_15.member;
let _e3020 = ((((_e3009.member.member * _e625) + (_e3009.member.member_1 * _e638)) + (_e3009.member.member_2 * _e603)) + _e3009.member_1);
let _e3026 = ((((_e3009.member.member * _e648) + (_e3009.member.member_1 * _e653)) + (_e3009.member.member_2 * _e642)) + _e3009.member_1);
let _e3028 = select(_e3026, _e3020, (_e3020 < _e3026));
let _e3030 = select(_e3026, _e3020, (_e3020 > _e3026));
let _e3032 = (_e3030 - _e3028);
let _e3035 = (-(_e3028) / select(1e-30f, _e3032, (_e3032 > 1e-30f)));
let _e3037 = select(0f, _e3035, (_e3035 > 0f));
let _e3043 = select(select(select(1f, _e3037, (_e3037 < 1f)), 1f, (_e3030 <= 0f)), 0f, (_e3028 > 0f));
let _e3048 = global_1.member.member_15.member_1;
let _e3049 = (_e3048 != 0u);
let _e3059 = global_1.member.member_16.member;
let _e3070 = ((((_e3059.member.member * _e625) + (_e3059.member.member_1 * _e638)) + (_e3059.member.member_2 * _e603)) + _e3059.member_1);
let _e3076 = ((((_e3059.member.member * _e648) + (_e3059.member.member_1 * _e653)) + (_e3059.member.member_2 * _e642)) + _e3059.member_1);
let _e3078 = select(_e3076, _e3070, (_e3070 < _e3076));
let _e3080 = select(_e3076, _e3070, (_e3070 > _e3076));
let _e3082 = (_e3080 - _e3078);
let _e3085 = (-(_e3078) / select(1e-30f, _e3082, (_e3082 > 1e-30f)));
let _e3087 = select(0f, _e3085, (_e3085 > 0f));
let _e3093 = select(select(select(1f, _e3087, (_e3087 < 1f)), 1f, (_e3080 <= 0f)), 0f, (_e3078 > 0f));
let _e3098 = global_1.member.member_16.member_1;
let _e3099 = (_e3098 != 0u);
let _e3109 = global_1.member.member_17.member;
let _e3120 = ((((_e3109.member.member * _e625) + (_e3109.member.member_1 * _e638)) + (_e3109.member.member_2 * _e603)) + _e3109.member_1);
let _e3126 = ((((_e3109.member.member * _e648) + (_e3109.member.member_1 * _e653)) + (_e3109.member.member_2 * _e642)) + _e3109.member_1);
let _e3128 = select(_e3126, _e3120, (_e3120 < _e3126));
let _e3130 = select(_e3126, _e3120, (_e3120 > _e3126));
let _e3132 = (_e3130 - _e3128);
let _e3135 = (-(_e3128) / select(1e-30f, _e3132, (_e3132 > 1e-30f)));
let _e3137 = select(0f, _e3135, (_e3135 > 0f));
let _e3143 = select(select(select(1f, _e3137, (_e3137 < 1f)), 1f, (_e3130 <= 0f)), 0f, (_e3128 > 0f));
let _e3148 = global_1.member.member_17.member_1;
let _e3149 = (_e3148 != 0u);
phi_4919_ = type_5(((((1f * _e2993) * _e3043) * _e3093) * _e3143), ((((1f * select(1f, _e2993, _e2999)) * select(1f, _e3043, _e3049)) * select(1f, _e3093, _e3099)) * select(1f, _e3143, _e3149)), ((((1f * select(1f, 0f, (_e2999 && (_e2976 > 0f)))) * select(1f, 0f, (_e3049 && (_e3026 > 0f)))) * select(1f, 0f, (_e3099 && (_e3076 > 0f)))) * select(1f, 0f, (_e3149 && (_e3126 > 0f)))));
}
let _e3158 = phi_4919_;
let _e3159 = (_e704 - _e668);
let _e3163 = (bitcast<f32>((bitcast<u32>(_e3159) & 2147483647u)) < 1e-12f);
let _e3165 = (1f / select(_e3159, 1f, _e3163));
let _e3167 = ((-0.5f - _e668) * _e3165);
let _e3169 = ((_e2577 - _e668) * _e3165);
let _e3175 = select(_e3169, _e3167, (_e3167 < _e3169));
let _e3177 = select(0f, _e3175, (_e3175 > 0f));
let _e3180 = select(select(1f, _e3177, (_e3177 < 1f)), select(2f, 0f, ((_e668 >= -0.5f) && (_e668 <= _e2577))), _e3163);
let _e3182 = select(_e3169, _e3167, (_e3167 > _e3169));
let _e3184 = select(0f, _e3182, (_e3182 > 0f));
let _e3187 = select(select(1f, _e3184, (_e3184 < 1f)), 1f, _e3163);
let _e3188 = (_e710 - _e683);
let _e3192 = (bitcast<f32>((bitcast<u32>(_e3188) & 2147483647u)) < 1e-12f);
let _e3194 = (1f / select(_e3188, 1f, _e3192));
let _e3196 = ((-0.5f - _e683) * _e3194);
let _e3198 = ((_e2587 - _e683) * _e3194);
let _e3204 = select(_e3198, _e3196, (_e3196 < _e3198));
let _e3206 = select(0f, _e3204, (_e3204 > 0f));
let _e3209 = select(select(1f, _e3206, (_e3206 < 1f)), select(2f, 0f, ((_e683 >= -0.5f) && (_e683 <= _e2587))), _e3192);
let _e3211 = select(_e3198, _e3196, (_e3196 > _e3198));
let _e3213 = select(0f, _e3211, (_e3211 > 0f));
let _e3216 = select(select(1f, _e3213, (_e3213 < 1f)), 1f, _e3192);
let _e3217 = (_e716 - _e698);
let _e3221 = (bitcast<f32>((bitcast<u32>(_e3217) & 2147483647u)) < 1e-12f);
let _e3223 = (1f / select(_e3217, 1f, _e3221));
let _e3225 = ((-0.5f - _e698) * _e3223);
let _e3227 = ((_e2597 - _e698) * _e3223);
let _e3233 = select(_e3227, _e3225, (_e3225 < _e3227));
let _e3235 = select(0f, _e3233, (_e3233 > 0f));
let _e3238 = select(select(1f, _e3235, (_e3235 < 1f)), select(2f, 0f, ((_e698 >= -0.5f) && (_e698 <= _e2597))), _e3221);
let _e3240 = select(_e3227, _e3225, (_e3225 > _e3227));
let _e3242 = select(0f, _e3240, (_e3240 > 0f));
let _e3245 = select(select(1f, _e3242, (_e3242 < 1f)), 1f, _e3221);
let _e3247 = select(_e3216, _e3187, (_e3187 < _e3216));
let _e3251 = select(_e3209, _e3180, (_e3180 > _e3209));
let _e3254 = (select(_e3245, _e3247, (_e3247 < _e3245)) - select(_e3238, _e3251, (_e3251 > _e3238)));
let _e3257 = (_e648 - _e625);
let _e3258 = (_e653 - _e638);
let _e3259 = (_e642 - _e603);
let _e3264 = (((_e3257 * _e3257) + (_e3258 * _e3258)) + (_e3259 * _e3259));
let _e3272 = global_1.member.member_5.member_3;
let _e3273 = ((sqrt(select(0f, _e3264, (_e3264 > 0f))) * select(0f, _e3254, (_e3254 > 0f))) * _e3272);
if (_e104.member_2 >= 3u) {
let _e3276 = (_e2950 * 255f);
let _e3277 = (_e2571.member * 255f);
let _e3278 = (255f - 1f);
let _e3280 = select(0f, _e3276, (_e3276 > 0f));
let _e3282 = select(_e3278, _e3280, (_e3280 < _e3278));
let _e3289 = select(0i, select(select(i32(_e3282), i32(-2147483648), (_e3282 < -2147483600f)), 2147483647i, (_e3282 > 2147483500f)), (_e3282 == _e3282));
let _e3293 = (_e3289 - select(0i, 1i, (_e3282 < f32(_e3289))));
let _e3295 = select(0f, _e3277, (_e3277 > 0f));
let _e3297 = select(_e3278, _e3295, (_e3295 < _e3278));
let _e3304 = select(0i, select(select(i32(_e3297), i32(-2147483648), (_e3297 < -2147483600f)), 2147483647i, (_e3297 > 2147483500f)), (_e3297 == _e3297));
let _e3308 = (_e3304 - select(0i, 1i, (_e3297 < f32(_e3304))));
let _e3311 = (((_e3293 * 256i) + _e3308) * 4i);
let _e3315 = (_e3277 - f32(_e3308));
let _e3317 = (bitcast<i32>(_e94) - 1i);
let _e3319 = select(_e3317, _e3311, (_e3311 < _e3317));
let _e3325 = global_4.member[bitcast<u32>(select(0i, _e3319, (_e3319 > 0i)))];
let _e3326 = (_e3311 + 4i);
let _e3328 = select(_e3317, _e3326, (_e3326 < _e3317));
let _e3334 = global_4.member[bitcast<u32>(select(0i, _e3328, (_e3328 > 0i)))];
let _e3335 = (_e3311 + 1024i);
let _e3337 = select(_e3317, _e3335, (_e3335 < _e3317));
let _e3343 = global_4.member[bitcast<u32>(select(0i, _e3337, (_e3337 > 0i)))];
let _e3344 = (_e3311 + 1028i);
let _e3346 = select(_e3317, _e3344, (_e3344 < _e3317));
let _e3352 = global_4.member[bitcast<u32>(select(0i, _e3346, (_e3346 > 0i)))];
let _e3357 = (bitcast<f32>(((_e3325 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3365 = (_e3357 + (((bitcast<f32>(((_e3334 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3357) * _e3315));
let _e3370 = (bitcast<f32>(((_e3343 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3381 = (_e3365 + (((_e3370 + (((bitcast<f32>(((_e3352 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3370) * _e3315)) - _e3365) * (_e3276 - f32(_e3293))));
let _e3385 = -((_e3381 * (_e3273 * _e3158.member)));
let _e3387 = select(-87f, _e3385, (_e3385 > -87f));
let _e3389 = select(88f, _e3387, (_e3387 < 88f));
let _e3391 = ((_e3389 * 1.442695f) + 0.5f);
let _e3393 = select(-127f, _e3391, (_e3391 > -127f));
let _e3395 = select(128f, _e3393, (_e3393 < 128f));
let _e3402 = select(0i, select(select(i32(_e3395), i32(-2147483648), (_e3395 < -2147483600f)), 2147483647i, (_e3395 > 2147483500f)), (_e3395 == _e3395));
let _e3406 = (_e3402 - select(0i, 1i, (_e3395 < f32(_e3402))));
let _e3407 = f32(_e3406);
let _e3411 = ((_e3389 - (_e3407 * 0.6933594f)) - (_e3407 * -2.1219444e-4f));
let _e3431 = ((1f + (_e3411 * (1f + (_e3411 * (0.5f + (_e3411 * (0.16666667f + (_e3411 * (0.041666668f + (_e3411 * (0.008333334f + (_e3411 * (0.001388889f + (_e3411 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3406 + 127i)) << bitcast<u32>(23i))));
let _e3432 = (1f - _e3431);
phi_6029_ = type_31(_e3431, _e3432, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3432 / select(1e-12f, _e3381, (_e3381 > 1e-12f))))));
} else {
let _e3440 = (_e2950 * 255f);
let _e3441 = (_e2571.member * 255f);
let _e3442 = (255f - 1f);
let _e3444 = select(0f, _e3440, (_e3440 > 0f));
let _e3446 = select(_e3442, _e3444, (_e3444 < _e3442));
let _e3453 = select(0i, select(select(i32(_e3446), i32(-2147483648), (_e3446 < -2147483600f)), 2147483647i, (_e3446 > 2147483500f)), (_e3446 == _e3446));
let _e3457 = (_e3453 - select(0i, 1i, (_e3446 < f32(_e3453))));
let _e3459 = select(0f, _e3441, (_e3441 > 0f));
let _e3461 = select(_e3442, _e3459, (_e3459 < _e3442));
let _e3468 = select(0i, select(select(i32(_e3461), i32(-2147483648), (_e3461 < -2147483600f)), 2147483647i, (_e3461 > 2147483500f)), (_e3461 == _e3461));
let _e3472 = (_e3468 - select(0i, 1i, (_e3461 < f32(_e3468))));
let _e3475 = (((_e3457 * 256i) + _e3472) * 4i);
let _e3477 = (_e3440 - f32(_e3457));
let _e3479 = (_e3441 - f32(_e3472));
let _e3481 = (bitcast<i32>(_e94) - 1i);
let _e3483 = select(_e3481, _e3475, (_e3475 < _e3481));
let _e3489 = global_4.member[bitcast<u32>(select(0i, _e3483, (_e3483 > 0i)))];
let _e3490 = (_e3475 + 4i);
let _e3492 = select(_e3481, _e3490, (_e3490 < _e3481));
let _e3498 = global_4.member[bitcast<u32>(select(0i, _e3492, (_e3492 > 0i)))];
let _e3499 = (_e3475 + 1024i);
let _e3501 = select(_e3481, _e3499, (_e3499 < _e3481));
let _e3507 = global_4.member[bitcast<u32>(select(0i, _e3501, (_e3501 > 0i)))];
let _e3508 = (_e3475 + 1028i);
let _e3510 = select(_e3481, _e3508, (_e3508 < _e3481));
let _e3516 = global_4.member[bitcast<u32>(select(0i, _e3510, (_e3510 > 0i)))];
let _e3521 = (bitcast<f32>(((_e3489 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3529 = (_e3521 + (((bitcast<f32>(((_e3498 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3521) * _e3479));
let _e3534 = (bitcast<f32>(((_e3507 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3545 = (_e3529 + (((_e3534 + (((bitcast<f32>(((_e3516 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3534) * _e3479)) - _e3529) * _e3477));
let _e3558 = (bitcast<f32>((((_e3489 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3566 = (_e3558 + (((bitcast<f32>((((_e3498 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3558) * _e3479));
let _e3571 = (bitcast<f32>((((_e3507 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3583 = (_e3475 + 1i);
let _e3585 = select(_e3481, _e3583, (_e3583 < _e3481));
let _e3591 = global_4.member[bitcast<u32>(select(0i, _e3585, (_e3585 > 0i)))];
let _e3592 = (_e3475 + 5i);
let _e3594 = select(_e3481, _e3592, (_e3592 < _e3481));
let _e3600 = global_4.member[bitcast<u32>(select(0i, _e3594, (_e3594 > 0i)))];
let _e3601 = (_e3475 + 1025i);
let _e3603 = select(_e3481, _e3601, (_e3601 < _e3481));
let _e3609 = global_4.member[bitcast<u32>(select(0i, _e3603, (_e3603 > 0i)))];
let _e3610 = (_e3475 + 1029i);
let _e3612 = select(_e3481, _e3610, (_e3610 < _e3481));
let _e3618 = global_4.member[bitcast<u32>(select(0i, _e3612, (_e3612 > 0i)))];
let _e3623 = (bitcast<f32>(((_e3591 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3631 = (_e3623 + (((bitcast<f32>(((_e3600 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3623) * _e3479));
let _e3636 = (bitcast<f32>(((_e3609 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3660 = (bitcast<f32>((((_e3591 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3668 = (_e3660 + (((bitcast<f32>((((_e3600 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3660) * _e3479));
let _e3673 = (bitcast<f32>((((_e3609 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3688 = (_e3273 * _e3158.member_1);
let _e3690 = -(((_e3566 + (((_e3571 + (((bitcast<f32>((((_e3516 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3571) * _e3479)) - _e3566) * _e3477)) * _e3688));
let _e3692 = select(-87f, _e3690, (_e3690 > -87f));
let _e3694 = select(88f, _e3692, (_e3692 < 88f));
let _e3696 = ((_e3694 * 1.442695f) + 0.5f);
let _e3698 = select(-127f, _e3696, (_e3696 > -127f));
let _e3700 = select(128f, _e3698, (_e3698 < 128f));
let _e3707 = select(0i, select(select(i32(_e3700), i32(-2147483648), (_e3700 < -2147483600f)), 2147483647i, (_e3700 > 2147483500f)), (_e3700 == _e3700));
let _e3711 = (_e3707 - select(0i, 1i, (_e3700 < f32(_e3707))));
let _e3712 = f32(_e3711);
let _e3716 = ((_e3694 - (_e3712 * 0.6933594f)) - (_e3712 * -2.1219444e-4f));
let _e3738 = -(((_e3631 + (((_e3636 + (((bitcast<f32>(((_e3618 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3636) * _e3479)) - _e3631) * _e3477)) * _e3688));
let _e3740 = select(-87f, _e3738, (_e3738 > -87f));
let _e3742 = select(88f, _e3740, (_e3740 < 88f));
let _e3744 = ((_e3742 * 1.442695f) + 0.5f);
let _e3746 = select(-127f, _e3744, (_e3744 > -127f));
let _e3748 = select(128f, _e3746, (_e3746 < 128f));
let _e3755 = select(0i, select(select(i32(_e3748), i32(-2147483648), (_e3748 < -2147483600f)), 2147483647i, (_e3748 > 2147483500f)), (_e3748 == _e3748));
let _e3759 = (_e3755 - select(0i, 1i, (_e3748 < f32(_e3755))));
let _e3760 = f32(_e3759);
let _e3764 = ((_e3742 - (_e3760 * 0.6933594f)) - (_e3760 * -2.1219444e-4f));
let _e3786 = -(((_e3668 + (((_e3673 + (((bitcast<f32>((((_e3618 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3673) * _e3479)) - _e3668) * _e3477)) * _e3688));
let _e3788 = select(-87f, _e3786, (_e3786 > -87f));
let _e3790 = select(88f, _e3788, (_e3788 < 88f));
let _e3792 = ((_e3790 * 1.442695f) + 0.5f);
let _e3794 = select(-127f, _e3792, (_e3792 > -127f));
let _e3796 = select(128f, _e3794, (_e3794 < 128f));
let _e3803 = select(0i, select(select(i32(_e3796), i32(-2147483648), (_e3796 < -2147483600f)), 2147483647i, (_e3796 > 2147483500f)), (_e3796 == _e3796));
let _e3807 = (_e3803 - select(0i, 1i, (_e3796 < f32(_e3803))));
let _e3808 = f32(_e3807);
let _e3812 = ((_e3790 - (_e3808 * 0.6933594f)) - (_e3808 * -2.1219444e-4f));
let _e3835 = -((_e3545 * (_e3273 * _e3158.member)));
let _e3837 = select(-87f, _e3835, (_e3835 > -87f));
let _e3839 = select(88f, _e3837, (_e3837 < 88f));
let _e3841 = ((_e3839 * 1.442695f) + 0.5f);
let _e3843 = select(-127f, _e3841, (_e3841 > -127f));
let _e3845 = select(128f, _e3843, (_e3843 < 128f));
let _e3852 = select(0i, select(select(i32(_e3845), i32(-2147483648), (_e3845 < -2147483600f)), 2147483647i, (_e3845 > 2147483500f)), (_e3845 == _e3845));
let _e3856 = (_e3852 - select(0i, 1i, (_e3845 < f32(_e3852))));
let _e3857 = f32(_e3856);
let _e3861 = ((_e3839 - (_e3857 * 0.6933594f)) - (_e3857 * -2.1219444e-4f));
let _e3881 = ((1f + (_e3861 * (1f + (_e3861 * (0.5f + (_e3861 * (0.16666667f + (_e3861 * (0.041666668f + (_e3861 * (0.008333334f + (_e3861 * (0.001388889f + (_e3861 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3856 + 127i)) << bitcast<u32>(23i))));
let _e3882 = (1f - _e3881);
phi_6029_ = type_31(_e3881, _e3882, vec3<f32>(((1f + (_e3716 * (1f + (_e3716 * (0.5f + (_e3716 * (0.16666667f + (_e3716 * (0.041666668f + (_e3716 * (0.008333334f + (_e3716 * (0.001388889f + (_e3716 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3711 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3764 * (1f + (_e3764 * (0.5f + (_e3764 * (0.16666667f + (_e3764 * (0.041666668f + (_e3764 * (0.008333334f + (_e3764 * (0.001388889f + (_e3764 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3759 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3812 * (1f + (_e3812 * (0.5f + (_e3812 * (0.16666667f + (_e3812 * (0.041666668f + (_e3812 * (0.008333334f + (_e3812 * (0.001388889f + (_e3812 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3807 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3882 / select(1e-12f, _e3545, (_e3545 > 1e-12f))))));
}
let _e3890 = phi_6029_;
if _e721 {
let _e3894 = global_1.member.member_5.member_2;
let _e3902 = global_1.member.member_5.member_4;
let _e3905 = (_e2571.member_3.x * _e3158.member_2);
let _e3907 = (_e2571.member_3.y * _e3158.member_2);
let _e3909 = (_e2571.member_3.z * _e3158.member_2);
let _e3910 = (0.5f * (_e3894 / select(1e-6f, _e184, (_e184 > 1e-6f))));
let _e3914 = (_e162 + (_e3905 * _e3910));
let _e3915 = (_e173 + (_e3907 * _e3910));
let _e3916 = (_e184 + (_e3909 * _e3910));
let _e3918 = (2f * _e3894);
let _e3920 = ((_e3916 * _e3916) + (_e3918 * _e3909));
let _e3924 = (_e3916 + sqrt(select(0f, _e3920, (_e3920 > 0f))));
let _e3928 = (0.5f * (_e3918 / select(1e-6f, _e3924, (_e3924 > 1e-6f))));
let _e3932 = (_e3914 + (_e3905 * _e3928));
let _e3933 = (_e3915 + (_e3907 * _e3928));
let _e3934 = (_e3916 + (_e3909 * _e3928));
let _e3938 = (_e3902 * _e3902);
let _e3940 = (_e3934 * _e3934);
let _e3948 = (((_e3916 <= 0f) || (_e3920 <= 0f)) || ((_e3934 <= 0f) || (_e3940 <= (_e3938 * (((_e3932 * _e3932) + (_e3933 * _e3933)) + _e3940)))));
let _e3962 = (_e162 + ((_e2571.member_4.x * _e3158.member_2) * _e3894));
let _e3963 = (_e173 + ((_e2571.member_4.y * _e3158.member_2) * _e3894));
let _e3964 = (_e184 + ((_e2571.member_4.z * _e3158.member_2) * _e3894));
let _e3966 = (_e3964 * _e3964);
let _e3975 = ((_e2953 & 1u) != 0u);
let _e3979 = select(_e3948, ((_e3964 <= 0f) || (_e3966 <= (_e3938 * (((_e3962 * _e3962) + (_e3963 * _e3963)) + _e3966)))), _e3975);
phi_6181_ = vec3<f32>(select(select(select(_e3932, _e3914, _e3948), _e3962, _e3975), _e162, _e3979), select(select(select(_e3933, _e3915, _e3948), _e3963, _e3975), _e173, _e3979), select(select(select(_e3934, _e3916, _e3948), _e3964, _e3975), _e184, _e3979));
phi_6182_ = select(1f, 0f, _e3979);
} else {
phi_6181_ = vec3<f32>(_e162, _e173, _e184);
phi_6182_ = 1f;
}
let _e3986 = phi_6181_;
let _e3988 = phi_6182_;
let _e3991 = (_e3890.member * _e3988);
global_5.member[_e119] = (_e130 * (_e3890.member_2.x * _e3991));
global_5.member[_e131] = (_e140 * (_e3890.member_2.y * _e3991));
global_5.member[_e142] = (_e151 * (_e3890.member_2.z * _e3991));
global_5.member[_e153] = _e3986.x;
global_5.member[_e164] = _e3986.y;
global_5.member[_e175] = _e3986.z;
global_5.member[_e186] = _e195;
global_5.member[_e197] = _e206;
global_5.member[_e208] = _e217;
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
